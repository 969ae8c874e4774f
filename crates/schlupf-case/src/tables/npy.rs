//! Arrays of numbers in `NumPy`'s .npy format (versions 1 to 3).

/// An array with each row contiguous.
#[derive(Debug, PartialEq)]
pub(crate) struct Array {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    pub(crate) values: Vec<f64>,
}

/// Reads a file with two dimensions; the error follows the name of the file in a sentence.
pub(crate) fn parse(bytes: &[u8]) -> Result<Array, String> {
    parse_shaped(bytes, |sizes| sizes.try_into().ok())
}

/// The same, where one dimension makes a single row.
pub(crate) fn parse_map_or_line(bytes: &[u8]) -> Result<Array, String> {
    parse_shaped(bytes, |sizes| match *sizes {
        [columns] => Some([1, columns]),
        _ => sizes.try_into().ok(),
    })
}

/// Reads a file whose sizes `shape` turns into rows and columns.
fn parse_shaped(
    bytes: &[u8],
    shape: impl Fn(&[usize]) -> Option<[usize; 2]>,
) -> Result<Array, String> {
    let not_npy = || "must be an .npy file, but is not".to_owned();
    let rest = bytes.strip_prefix(b"\x93NUMPY").ok_or_else(not_npy)?;
    let (&[major, _minor], rest) = rest.split_first_chunk().ok_or_else(not_npy)?;
    let (length, rest) = if major == 1 {
        let (length, rest) = rest.split_first_chunk().ok_or_else(not_npy)?;
        (usize::from(u16::from_le_bytes(*length)), rest)
    } else {
        let (length, rest) = rest.split_first_chunk().ok_or_else(not_npy)?;
        (u32::from_le_bytes(*length) as usize, rest)
    };
    let (header, data) = rest.split_at_checked(length).ok_or_else(not_npy)?;
    let header = std::str::from_utf8(header).map_err(|_| not_npy())?;
    let (sizes, text) = sizes(header)?;
    let unfit = || format!("must have two dimensions, but has the shape {text}");
    let [rows, columns] = shape(&sizes).ok_or_else(unfit)?;
    let values = numbers(header, data)?;
    if rows.checked_mul(columns) != Some(values.len()) {
        let found = values.len();
        return Err(format!("must hold {rows} by {columns} numbers, but holds {found}"));
    }
    let values = match entry(header, "fortran_order") {
        Some("True") => transposed(&values, rows, columns),
        Some("False") => values,
        _ => return Err(not_npy()),
    };
    Ok(Array { rows, columns, values })
}

/// The text of an entry of the header, a Python dictionary of three literals.
fn entry<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let (_, after) = header.split_once(&format!("'{key}':"))?;
    let after = after.trim_start();
    let end = if after.starts_with('(') { after.find(')')? + 1 } else { after.find([',', '}'])? };
    Some(after[..end].trim())
}

/// The sizes along each dimension, and how they are written.
fn sizes(header: &str) -> Result<(Vec<usize>, &str), String> {
    let text = entry(header, "shape").unwrap_or_default();
    let sizes: Result<Vec<usize>, _> = text
        .trim_matches(['(', ')'])
        .split(',')
        .map(str::trim)
        .filter(|size| !size.is_empty())
        .map(str::parse)
        .collect();
    let sizes = sizes.map_err(|_| format!("must have a shape of whole numbers, but has {text}"))?;
    Ok((sizes, text))
}

fn numbers(header: &str, data: &[u8]) -> Result<Vec<f64>, String> {
    let kind = entry(header, "descr").unwrap_or_default().trim_matches(['\'', '"']);
    let is_big = kind.starts_with('>');
    let values = match kind.trim_start_matches(['<', '>', '|']) {
        "f8" => each(data, is_big, f64::from_le_bytes),
        "f4" => each(data, is_big, |bytes| f32::from_le_bytes(bytes).into()),
        "i8" => each(data, is_big, |bytes| i64::from_le_bytes(bytes) as f64),
        "i4" => each(data, is_big, |bytes| i32::from_le_bytes(bytes).into()),
        "i2" => each(data, is_big, |bytes| i16::from_le_bytes(bytes).into()),
        "i1" => each(data, is_big, |bytes| i8::from_le_bytes(bytes).into()),
        "u8" => each(data, is_big, |bytes| u64::from_le_bytes(bytes) as f64),
        "u4" => each(data, is_big, |bytes| u32::from_le_bytes(bytes).into()),
        "u2" => each(data, is_big, |bytes| u16::from_le_bytes(bytes).into()),
        "u1" => each(data, is_big, |bytes| u8::from_le_bytes(bytes).into()),
        _ => {
            return Err(format!(
                "must hold integers or 32- or 64-bit floating-point numbers, but holds {kind}"
            ));
        }
    };
    values.ok_or_else(|| "ends in the middle of a number".to_owned())
}

/// Numbers of so many bytes, those of big-endian ones the other way round.
fn each<const N: usize>(
    data: &[u8],
    is_big: bool,
    convert: impl Fn([u8; N]) -> f64,
) -> Option<Vec<f64>> {
    let (chunks, rest) = data.as_chunks::<N>();
    let number = |chunk: &[u8; N]| {
        let mut bytes = *chunk;
        if is_big {
            bytes.reverse();
        }
        convert(bytes)
    };
    rest.is_empty().then(|| chunks.iter().map(number).collect())
}

/// Column after column to row after row.
fn transposed(values: &[f64], rows: usize, columns: usize) -> Vec<f64> {
    (0..rows * columns).map(|cell| values[cell % columns * rows + cell / columns]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(header: &str, data: &[u8]) -> Vec<u8> {
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((header.len() as u16).to_le_bytes());
        bytes.extend(header.as_bytes());
        bytes.extend(data);
        bytes
    }

    fn header(kind: &str, fortran: &str, shape: &str) -> String {
        format!("{{'descr': '{kind}', 'fortran_order': {fortran}, 'shape': {shape}, }}\n")
    }

    fn doubles(count: usize) -> Vec<u8> {
        (0..count).flat_map(|i| (i as f64).to_le_bytes()).collect()
    }

    #[test]
    fn both_orders_and_sizes_give_the_same_rows() {
        let c = parse(&file(&header("<f8", "False", "(2, 3)"), &doubles(6))).unwrap();
        assert_eq!(c, Array { rows: 2, columns: 3, values: vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0] });
        let order = [0.0, 3.0, 1.0, 4.0, 2.0, 5.0];
        let singles: Vec<u8> = order.iter().flat_map(|x| (*x as f32).to_be_bytes()).collect();
        let fortran = parse(&file(&header(">f4", "True", "(2, 3)"), &singles)).unwrap();
        assert_eq!(fortran, c);
    }

    /// Heights as instruments count them.
    #[test]
    fn integers_are_numbers() {
        let read = |kind: &str, data: &[u8]| {
            parse(&file(&header(kind, "False", "(1, 2)"), data)).unwrap().values
        };
        assert_eq!(read("|u1", &[7, 255]), [7.0, 255.0]);
        assert_eq!(read("|i1", &[7, 255]), [7.0, -1.0]);
        assert_eq!(read("<i2", &[1, 0, 254, 255]), [1.0, -2.0]);
        assert_eq!(read(">u2", &[1, 0, 0, 3]), [256.0, 3.0]);
        let of = |values: [i64; 2]| values.map(i64::to_be_bytes).concat();
        assert_eq!(read(">i8", &of([-5, 1 << 40])), [-5.0, 2_f64.powi(40)]);
    }

    #[test]
    fn one_dimension_is_a_row_where_that_is_legal() {
        let line = file(&header("<f8", "False", "(6,)"), &doubles(6));
        let array = parse_map_or_line(&line).unwrap();
        assert_eq!((array.rows, array.columns), (1, 6));
        let cube = file(&header("<f8", "False", "(1, 2, 3)"), &doubles(6));
        assert!(parse_map_or_line(&cube).unwrap_err().contains("two dimensions"));
    }

    #[test]
    fn other_files_are_refused() {
        let cases = [
            (b"x,y\n".to_vec(), "must be an .npy file"),
            (file(&header("<c8", "False", "(2, 3)"), &doubles(6)), "floating-point"),
            (file(&header("<f8", "False", "(6,)"), &doubles(6)), "two dimensions"),
            (file(&header("<f8", "False", "(2, 4)"), &doubles(6)), "must hold 2 by 4 numbers"),
            (file(&header("<f8", "False", "(2, 3)"), &doubles(6)[..47]), "in the middle"),
            (file(&header("<f8", "maybe", "(2, 3)"), &doubles(6)), "must be an .npy file"),
            (file("", &[]), "two dimensions"),
        ];
        for (bytes, expected) in cases {
            let message = parse(&bytes).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
        let whole = file(&header("<f8", "False", "(2, 3)"), &doubles(6));
        for length in 0..whole.len() {
            assert!(parse(&whole[..length]).is_err());
        }
    }
}
