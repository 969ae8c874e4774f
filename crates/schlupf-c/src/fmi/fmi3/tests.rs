//! Wrong calls, and derivatives both ways.

use std::ffi::CString;
use std::sync::Mutex;

use schlupf::unwatched;
use schlupf_case::fmu::Resources;
use schlupf_case::{CaseFile, Folder, Overrides};

use super::*;

unsafe extern "C" fn keep(
    to: *mut c_void,
    _status: Status,
    _category: *const c_char,
    message: *const c_char,
) {
    let messages = unsafe { &*to.cast::<Mutex<Vec<String>>>() };
    messages.lock().unwrap().push(unsafe { text(message) }.into_owned());
}

/// Those of a unit with a method, put into a folder; returns its token.
fn resources(folder: &Path, method: &str) -> String {
    let text = format!("solver.method = \"{method}\"");
    let file = CaseFile::from_str(&text, "case", Folder::new(""), Overrides::NONE).unwrap();
    let (resources, _) = Resources::of(&file, &unwatched).unwrap();
    for (name, bytes) in resources.members() {
        std::fs::write(folder.join(name), bytes).unwrap();
    }
    resources.token()
}

fn instantiate(folder: &Path, token: &str, messages: &Mutex<Vec<String>>) -> *mut Component {
    let [folder, token] = [folder.to_str().unwrap(), token].map(|of| CString::new(of).unwrap());
    let environment = ptr::from_ref(messages).cast_mut().cast();
    let (token, folder) = (token.as_ptr(), folder.as_ptr());
    let no = ptr::null();
    unsafe {
        fmi3InstantiateCoSimulation(
            c"contact".as_ptr(),
            token,
            folder,
            false,
            true,
            false,
            false,
            no,
            0,
            environment,
            Some(keep),
            no.cast(),
        )
    }
}

/// Null pointers, references and sizes that are wrong, resources of another unit: a status and
/// a message each.
#[test]
fn wrong_calls_end_in_a_status() {
    let folder = tempfile::tempdir().unwrap();
    let messages = Mutex::new(Vec::new());
    let last = || messages.lock().unwrap().pop().unwrap();
    assert!(instantiate(folder.path(), "", &messages).is_null());
    assert!(last().contains("files.json"));
    let token = resources(folder.path(), "polach");
    assert!(instantiate(folder.path(), "another", &messages).is_null());
    assert!(last().contains("but is another"));
    let one = instantiate(folder.path(), &token, &messages);
    let mut value = [0.0; 2];
    let place = value.as_mut_ptr();
    let get = |references: *const u32, count, number| unsafe {
        fmi3GetFloat64(one, references, count, place, number)
    };
    assert_eq!(get([1].as_ptr(), 1, 1), Status::Ok);
    assert_eq!(get([99].as_ptr(), 1, 1), Status::Error);
    assert_eq!(last(), "there is no variable with the value reference 99");
    assert_eq!(get(ptr::null(), 1, 1), Status::Error);
    assert_eq!(last(), "an array is null or not aligned");
    assert_eq!(get([1].as_ptr(), 1, 2), Status::Error);
    assert!(last().contains("but there are 2 for 1"));
    unsafe {
        // Before the end of the initialization.
        let no = ptr::null_mut();
        let early = fmi3DoStep(one, 0.0, 1.0, false, no, no, no, no.cast());
        assert_eq!(early, Status::Error);
        assert_eq!(fmi3SetFMUState(one, ptr::null()), Status::Error);
        assert_eq!(
            fmi3DeserializeFMUState(one, [1; 9].as_ptr(), 9, &mut ptr::null_mut()),
            Status::Error
        );
        assert_eq!(last(), "the bytes are not those of a state of this FMU");
        fmi3FreeInstance(one);
        assert_eq!(fmi3Reset(ptr::null_mut()), Status::Error);
        fmi3FreeInstance(ptr::null_mut());
    }
}

/// The adjoint derivatives are those in directions, transposed.
#[test]
fn adjoint_derivatives_are_the_transposed() {
    let folder = tempfile::tempdir().unwrap();
    let token = resources(folder.path(), "shen-hedrick-elkins");
    let one = instantiate(folder.path(), &token, &Mutex::default());
    // Forces and rates; velocities and elastic shifts.
    let (unknowns, knowns) = ([9, 10, 21], [1, 4, 18, 19]);
    let mut all = [[0.0; 3]; 4];
    for (k, column) in all.iter_mut().enumerate() {
        let place = column.as_mut_ptr();
        let of = unknowns.as_ptr();
        let status = unsafe {
            fmi3GetDirectionalDerivative(one, of, 3, &raw const knowns[k], 1, &1.0, 1, place, 3)
        };
        assert_eq!(status, Status::Ok);
    }
    let (seed, mut found) = ([1.0, -2.0, 3e-3], [0.0; 4]);
    let (of, by) = (unknowns.as_ptr(), knowns.as_ptr());
    let (given, place) = (seed.as_ptr(), found.as_mut_ptr());
    let status = unsafe { fmi3GetAdjointDerivative(one, of, 3, by, 4, given, 3, place, 4) };
    assert_eq!(status, Status::Ok);
    let exact: [f64; 4] =
        all.map(|column| column.iter().zip(seed).map(|(one, seed)| one * seed).sum());
    assert_eq!(found, exact);
    assert!(found.iter().all(|number| *number != 0.0), "{found:?}");
    unsafe { fmi3FreeInstance(one) };
}
