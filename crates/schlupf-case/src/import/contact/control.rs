//! The control digits of a case.

use super::given::{At, Given, Item, whole};
use super::reader::{Reader, Reading};

/// A digit with its name and the values that it may have.
#[derive(Debug)]
struct Digit {
    name: &'static str,
    allowed: &'static [i64],
}

const fn digit(name: &'static str, allowed: &'static [i64]) -> Digit {
    Digit { name, allowed }
}

const ANY: &[i64] = &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9];
const TO_1: &[i64] = &[0, 1];
const TO_2: &[i64] = &[0, 1, 2];
const TO_3: &[i64] = &[0, 1, 2, 3];
const TO_5: &[i64] = &[0, 1, 2, 3, 4, 5];
const TO_6: &[i64] = &[0, 1, 2, 3, 4, 5, 6];
const TO_7: &[i64] = &[0, 1, 2, 3, 4, 5, 6, 7];

/// The first words of module 1 and module 3.
const FIRST_1: [Digit; 7] = [
    digit("C1", &[0, 1, 4, 5]),
    digit("P", TO_3),
    digit("B", &[0, 1, 5, 6]),
    digit("T", TO_3),
    digit("N", TO_1),
    digit("F", TO_3),
    digit("S", TO_3),
];
const FIRST_3: [Digit; 6] = [
    digit("P", TO_3),
    digit("B", TO_6),
    digit("T", TO_3),
    digit("N", TO_1),
    digit("F", TO_2),
    digit("S", TO_3),
];
/// The second ones.
const SECOND_1: [Digit; 7] = [
    digit("V", TO_2),
    digit("L", TO_6),
    digit("D", ANY),
    digit("C3", &[0, 1, 2, 3, 4]),
    digit("M", TO_7),
    digit("Z", TO_3),
    digit("E", TO_5),
];
const SECOND_3: [Digit; 7] = [
    digit("V", &[0, 3]),
    digit("L", TO_6),
    digit("D", TO_2),
    digit("C3", &[0, 1, 2, 3, 4, 9]),
    digit("M", TO_7),
    digit("Z", TO_2),
    digit("E", &[0, 1, 2, 3, 9]),
];
/// The third word of both.
const THIRD: [Digit; 8] = [
    digit("X", TO_1),
    digit("H", &[0, 1, 3]),
    digit("G", TO_5),
    digit("I", TO_3),
    digit("A", TO_2),
    digit("O", TO_6),
    digit("W", ANY),
    digit("R", TO_3),
];

/// The control digits of a case. Their values are those of CONTACT's user guide, §3.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Control {
    /// CONFIG: which wheel, and whether it runs on a roller (module 1).
    pub config: Given,
    /// PVTIME: whether the case goes on from the one before.
    pub previous: Given,
    /// BOUND: where the pressure comes from.
    pub bound: Given,
    /// TANG: frictionless, shift, transient or steady rolling.
    pub tangential: Given,
    /// NORM: whether the approach or the force is given.
    pub normal: Given,
    /// FORCE: which tangential forces are given.
    pub force: Given,
    /// STRESS: stresses below the surface.
    pub stress: Given,
    /// VARFRC: where friction varies.
    pub friction_variation: Given,
    /// FRCLAW: the law of friction.
    pub friction_law: Given,
    /// DISCNS: the grid (module 3), or the approach to curved contacts (module 1).
    pub grid: Given,
    /// INFLCF: the influence coefficients.
    pub influence: Given,
    /// MATER: the material.
    pub material: Given,
    /// RZNORM: the undeformed distance (module 3), or ZTRACK: the track (module 1).
    pub distance: Given,
    /// EXRHS: an extra slip (module 3), or EWHEEL: the wheelset (module 1).
    pub extra: Given,
    /// MATER2: damping.
    pub damping: Given,
    /// XFLOW: whether the digits of a fourth word follow.
    pub debugging: Given,
    /// HEAT: surface temperatures.
    pub heat: Given,
    /// GAUSEI: settings of the solvers.
    pub iteration: Given,
    /// RETURN: what follows the case.
    pub following: Given,
}

impl Control {
    /// The digits of a case of module 1 or 3.
    pub fn read(reader: &mut Reader, module: i64) -> Reading<Self> {
        let [first, second, third] = match module {
            1 => ["CPBTNFS", "VLDCMZE", "XHGIAOWR"],
            _ => ["PBTNFS", "VLDCMZE", "XHGIAOWR"],
        };
        let (first_digits, second_digits) =
            if module == 1 { (&FIRST_1[..], &SECOND_1) } else { (&FIRST_3[..], &SECOND_3) };
        let [word] = reader.numbers([whole(first)])?;
        let first = unpacked(reader, word, first_digits)?;
        let ([word], [damping]) = reader.numbers_and([whole(second)], [DAMPING])?;
        let second = unpacked(reader, word, second_digits)?;
        let [word] = reader.numbers([whole(third)])?;
        let third = unpacked(reader, word, &THIRD)?;
        // Module 3 has no digit C1.
        let config = Given { name: "C1", value: 0.0, at: word.at };
        let (config, first) = match first[..] {
            [config, ref rest @ ..] if module == 1 => (config, rest),
            _ => (config, &first[..]),
        };
        let [previous, bound, tangential, normal, force, stress] = array(first, word);
        let [friction_variation, friction_law, grid, influence, material, distance, extra] =
            array(&second, word);
        let [debugging, heat, iteration, _, _, _, _, following] = array(&third, word);
        let unchanged = Given { name: DAMPING.name, value: 1.0, at: word.at };
        let damping = damping.map_or(unchanged, |word| {
            // The tens are the weighting of gaps.
            Given { value: (word.whole() % 10) as f64, ..word }
        });
        let control = Self {
            config,
            previous,
            bound,
            tangential,
            normal,
            force,
            stress,
            friction_variation,
            friction_law,
            grid,
            influence,
            material,
            distance,
            extra,
            damping,
            debugging,
            heat,
            iteration,
            following,
        };
        if control.debugging.is(1) {
            reader.numbers_and([whole("PSFLCIN")], [whole("READLN")])?;
        }
        Ok(control)
    }

    /// Whether the wheel rolls.
    pub fn is_rolling(&self) -> bool {
        self.tangential.value >= 2.0
    }
}

const DAMPING: Item = whole("M2");

/// The digits of a word, of which leading zeros may be left out.
fn unpacked(reader: &Reader, word: Given, digits: &[Digit]) -> Reading<Vec<Given>> {
    let mut rest = word.whole();
    let mut values: Vec<i64> = digits
        .iter()
        .map(|_| {
            let digit = rest % 10;
            rest /= 10;
            digit
        })
        .collect();
    values.reverse();
    if word.whole() < 0 || rest > 0 {
        let message = format!(
            "{} must have {} digits at most, but is {}",
            word.name,
            digits.len(),
            word.whole()
        );
        return Err(reader.error(word.name, word.at, message));
    }
    let pairs = digits.iter().zip(values).enumerate();
    pairs
        .map(|(place, (digit, value))| {
            let at = digit_at(word.at, digits.len() - place);
            if digit.allowed.contains(&value) {
                return Ok(Given { name: digit.name, value: value as f64, at });
            }
            let allowed: Vec<String> = digit.allowed.iter().map(ToString::to_string).collect();
            let message = format!(
                "digit {} of {} must be one of {}, but is {value}",
                digit.name,
                word.name,
                allowed.join(", ")
            );
            Err(reader.error(digit.name, at, message))
        })
        .collect()
}

/// Where a digit stands, counted from the end of its word; the word where it is left out.
fn digit_at(word: At, from_end: usize) -> At {
    let [start, end] = word.bytes;
    match end.checked_sub(from_end) {
        Some(place) if place >= start => At { bytes: [place, place + 1], ..word },
        _ => word,
    }
}

/// The digits in their order; of a word that has fewer the rest are zero.
fn array<const N: usize>(digits: &[Given], word: Given) -> [Given; N] {
    std::array::from_fn(|k| digits.get(k).copied().unwrap_or(Given { value: 0.0, ..word }))
}
