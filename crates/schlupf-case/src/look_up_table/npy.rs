//! Arrays in NumPy's .npy format, version 1.0, little-endian, the last index fastest.

const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";

/// The header including its magic string ends at a multiple of this.
const ALIGNMENT: usize = 64;

/// A number of fixed size.
pub trait Number: Copy {
    /// Its type in NumPy.
    const TYPE: &'static str;
    /// Its bytes.
    const SIZE: usize;
    /// To bytes.
    fn bytes(self) -> Vec<u8>;
    /// From as many bytes as it has.
    fn parsed(bytes: &[u8]) -> Option<Self>;
}

macro_rules! numbers {
    ($($number:ty, $name:literal;)+) => {$(
        impl Number for $number {
            const TYPE: &'static str = $name;
            const SIZE: usize = size_of::<$number>();

            fn bytes(self) -> Vec<u8> {
                self.to_le_bytes().to_vec()
            }

            fn parsed(bytes: &[u8]) -> Option<Self> {
                Some(Self::from_le_bytes(bytes.try_into().ok()?))
            }
        }
    )+};
}

numbers! {
    f32, "<f4";
    f64, "<f8";
}

/// An array as a file.
pub fn array<N: Number>(shape: &[usize], values: impl IntoIterator<Item = N>) -> Vec<u8> {
    let mut bytes = header::<N>(shape);
    bytes.extend(values.into_iter().flat_map(Number::bytes));
    bytes
}

/// The numbers of a file with an array of a known shape.
pub fn parse<N: Number>(bytes: &[u8], shape: &[usize]) -> Option<Vec<N>> {
    let data = bytes.strip_prefix(header::<N>(shape).as_slice())?;
    let count = shape.iter().try_fold(1_usize, |product, size| product.checked_mul(*size))?;
    if Some(data.len()) != count.checked_mul(N::SIZE) {
        return None;
    }
    data.chunks_exact(N::SIZE).map(N::parsed).collect()
}

fn header<N: Number>(shape: &[usize]) -> Vec<u8> {
    // NumPy writes a tuple of one with a comma at its end.
    let sizes: Vec<String> = shape.iter().map(usize::to_string).collect();
    let comma = if shape.len() == 1 { "," } else { "" };
    let mut text = format!(
        "{{'descr': '{}', 'fortran_order': False, 'shape': ({}{comma}), }}",
        N::TYPE,
        sizes.join(", ")
    );
    let before = MAGIC.len() + 2;
    let total = (before + text.len() + 1).next_multiple_of(ALIGNMENT);
    text.push_str(&" ".repeat(total - before - text.len() - 1));
    text.push('\n');
    let mut bytes = MAGIC.to_vec();
    // Some 80 to 130 characters.
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.as_bytes());
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let bytes = array(&[2, 3], [1.0_f32, 2.0, 3.0, 4.0, 5.0, -6.5]);
        assert_eq!(bytes.len() % 64, 24);
        assert_eq!(parse(&bytes, &[2, 3]), Some(vec![1.0_f32, 2.0, 3.0, 4.0, 5.0, -6.5]));
        assert_eq!(parse::<f32>(&bytes, &[3, 2]), None);
        assert_eq!(parse::<f64>(&bytes, &[2, 3]), None);
        assert_eq!(parse::<f32>(&bytes[..bytes.len() - 1], &[2, 3]), None);
        assert_eq!(parse::<f64>(&array(&[1], [2.5]), &[1]), Some(vec![2.5]));
    }
}
