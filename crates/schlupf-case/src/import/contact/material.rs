//! Materials: digits C3, M, B, M2 and H.

use super::control::Control;
use super::given::{Given, real, whole};
use super::reader::{Reader, Reading};

/// Materials and how their influence is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Elastic {
    /// Digit C3, 2 to 9.
    pub influence: Given,
    /// POISS of bodies 1 and 2.
    pub poisson: [Given; 2],
    /// GG of bodies 1 and 2, in N/mm².
    pub shear_modulus: [Given; 2],
    /// Parameters of the material model, in their order.
    pub model: Vec<Given>,
}

/// Most points of a table of inclinations.
const MOST_POINTS: i64 = 100_000;

impl Elastic {
    /// Reads them.
    pub fn read(reader: &mut Reader, control: &Control, module: i64) -> Reading<Self> {
        let influence = control.influence;
        if influence.is(4) {
            inclinations(reader, module)?;
        }
        if influence.is(9) {
            reader.text_and("CFNAME", [], [])?;
        }
        let [poisson_1, poisson_2, shear_1, shear_2] =
            reader.numbers([real("POISS1"), real("POISS2"), real("GG1"), real("GG2")])?;
        if control.bound.is(1) {
            reader.numbers([real("FLXZ")])?;
        }
        let items: &[_] = match control.material.whole() {
            1 => &[real("FG1"), real("FG2"), real("TC1"), real("TC2")],
            2 => &[real("FLX"), real("K0_MF"), real("ALFAMF"), real("BETAMF")],
            3 | 5 => &[real("K0_MF"), real("ALFAMF"), real("BETAMF")],
            4 => &[real("GG3"), real("LAYTHK"), real("TAU_C0"), real("K_TAU")],
            _ => &[],
        };
        let model = if items.is_empty() { Vec::new() } else { reader.group_of(items)? };
        let (poisson, shear_modulus) = ([poisson_1, poisson_2], [shear_1, shear_2]);
        Ok(Self { influence, poisson, shear_modulus, model })
    }
}

/// The correction for conformal bodies, in module 3 with a table of their inclinations.
fn inclinations(reader: &mut Reader, module: i64) -> Reading<()> {
    let head = [whole("IF_METH"), whole("VARIANT"), whole("NN")];
    if module == 1 {
        return reader.group_of(&head[..2]).map(|_| ());
    }
    let [_, _, count] = reader.numbers(head)?;
    let points = count.whole().clamp(1, MOST_POINTS) as usize;
    reader.array(real("Y, ALPHA"), 2 * points).map(|_| ())
}

/// Reads the parameters of damping.
pub fn skip_damping(reader: &mut Reader, control: &Control) -> Reading<()> {
    if control.damping.value >= 2.0 {
        reader.numbers([real("CDAMPN"), real("CDAMPT"), real("DFNMAX"), real("DFTMAX")])?;
    }
    Ok(())
}

/// What heats up, body by body: BKTEMP in °C, HEATCP in J/(kg K), LAMBDA in W/(mm K), DENS in
/// kg/mm³.
#[derive(Debug, Clone, PartialEq)]
pub struct Heat {
    /// Of bodies 1 and 2.
    pub bodies: [[Given; 4]; 2],
    /// BETAPL: the part of the plastic work that heats, of a layer between them.
    pub plastic_part: Option<Given>,
}

impl Heat {
    /// Reads them.
    pub fn read(reader: &mut Reader, control: &Control) -> Reading<Self> {
        let first =
            reader.numbers([real("BKTEMP1"), real("HEATCP1"), real("LAMBDA1"), real("DENS1")])?;
        let second =
            reader.numbers([real("BKTEMP2"), real("HEATCP2"), real("LAMBDA2"), real("DENS2")])?;
        let has_layer = control.material.is(4);
        let plastic_part = if has_layer {
            let [part] = reader.numbers([real("BETAPL")])?;
            Some(part)
        } else {
            None
        };
        Ok(Self { bodies: [first, second], plastic_part })
    }
}
