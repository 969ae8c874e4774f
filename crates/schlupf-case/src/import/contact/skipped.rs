//! Values that no case of ours needs: they are read to find what follows them.

use super::control::Control;
use super::given::{Given, Item, real, whole};
use super::reader::{Reader, Reading};

/// Most points along an axis of a block below the surface.
const MOST_POINTS: i64 = 1_000_000;

/// Settings of the solvers, digit G; of them MAXOUT counts, if it is given.
pub fn iteration(reader: &mut Reader, control: &Control) -> Reading<Option<Given>> {
    let method = control.iteration.whole();
    if method == 1 {
        return Ok(None);
    }
    let ([_, _, _, outer, _], _) = reader.numbers_and(
        [whole("MAXGS"), whole("MAXIN"), whole("MAXNR"), whole("MAXOUT"), real("EPS")],
        [whole("NPOT_MAX")],
    )?;
    let items: &[Item] = match method {
        2 | 3 => &[real("OMEGAH"), real("OMEGAS"), real("INISLP"), real("OMGSLP")],
        4 => &[real("INISLP"), real("OMGSLP")],
        5 => &[
            real("FDECAY"),
            real("BETATH"),
            whole("KDOWFB"),
            real("D_IFC"),
            real("D_LIN"),
            real("D_CNS"),
            real("D_SLP"),
            real("POW_S"),
        ],
        _ => &[],
    };
    if !items.is_empty() {
        reader.group_of(items)?;
    }
    Ok(Some(outer))
}

/// Points below the surface: digit S.
pub fn points_below(reader: &mut Reader, control: &Control) -> Reading<()> {
    if control.stress.value < 2.0 {
        return Ok(());
    }
    reader.numbers([whole("MATFIL"), whole("OUTPUT")])?;
    if control.stress.is(2) {
        return Ok(());
    }
    loop {
        let [kind] = reader.numbers([whole("ISUBS")])?;
        match kind.whole() {
            0 => return Ok(()),
            1 | 5 => {}
            2 | 6 => {
                reader.numbers([whole("IXL"), whole("IXINC"), whole("IXH")])?;
                reader.numbers([whole("IYL"), whole("IYINC"), whole("IYH")])?;
            }
            3 | 7 => {
                let [x, y] = reader.numbers([whole("NX"), whole("NY")])?;
                reader.array(whole("IX"), points(x.whole()))?;
                reader.array(whole("IY"), points(y.whole()))?;
            }
            9 => {
                let counts = reader.numbers([whole("NX"), whole("NY"), whole("NZ")])?;
                for (count, name) in counts.into_iter().zip(["X", "Y", "Z"]) {
                    reader.array(real(name), points(count.whole()))?;
                }
            }
            other => {
                let message = format!("ISUBS must be 0, 1, 2, 3, 5, 6, 7 or 9, but is {other}");
                return Err(reader.error("ISUBS", kind.at, message));
            }
        }
        match kind.whole() {
            1..=3 => {
                reader.numbers([whole("NZ"), real("ZL"), real("DZ")])?;
            }
            5..=7 => {
                let [count] = reader.numbers([whole("NZ")])?;
                reader.array(real("Z"), points(count.whole()))?;
            }
            _ => {}
        }
    }
}

fn points(count: i64) -> usize {
    count.clamp(0, MOST_POINTS) as usize
}
