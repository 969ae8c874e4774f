//! The force element of a case, and the table of the contacts of its wheel.

use schlupf::bodies::ReferencePoint;
use schlupf::element::{self, Element, WheelParts};
use schlupf::wheel_rail::{
    ContactTable, ContactTableErrors, ContactTableOptions, Motion, Position, WheelOnRail,
    WheelSolution,
};
use schlupf::{Error, Watch};

use super::Case;
use crate::contact_table::{self, Wanted};
use crate::error::CaseError;
use crate::{FieldNames, FieldPath, names, read};

impl Case {
    /// The force element of its contact, or of its wheel with two profiles, for simulations:
    /// section `element` says what it takes.
    ///
    /// # Errors
    /// Forces in place of creepages, a history, another reference point than the patch, a wheel
    /// without a table of its contacts, and what [`Element::new`] and [`Element::of_wheel`] reject.
    pub fn element(&self) -> Result<Element, CaseError> {
        let settings = read::element(&self.file.settings)?;
        if let (Some(wheel), Some(solver)) = (&self.wheel, &self.wheel_solver) {
            return self.element_of_wheel((wheel, solver.request.wheel()), settings);
        }
        if let Some(quantity) = self.problem.prescribed.first() {
            let field = names::quantity_field(quantity).unwrap_or(field!("kinematics.force_x"));
            return Err(self.contradiction(field, "a force element takes its motion as an input"));
        }
        self.require_steady("a force element is")?;
        if self.problem.reference != ReferencePoint::Patch {
            let reason = "the motion of a force element is that of the middle of the patch";
            return Err(self.contradiction(field!("kinematics.reference"), reason));
        }
        let method = (&self.method, &self.options);
        Element::new(&self.problem, method, settings).map_err(|error| match error {
            Error::ApproachOfElement {} => {
                let reason = error.text(&FieldNames::CASE);
                self.contradiction(field!("element.normal"), &reason)
            }
            _ => self.explain(&error),
        })
    }

    fn element_of_wheel(
        &self,
        (found, wheel): (&WheelSolution, &WheelOnRail),
        settings: element::Settings,
    ) -> Result<Element, CaseError> {
        const TABLE: FieldPath = field!("element.contact_table");
        let file = &self.file.settings;
        if let Err(missing) = file.setting(TABLE) {
            let help = "`schlupf table CASE --output contacts.npz` makes the contacts of a wheel \
                        with two profiles";
            return Err(missing.help(help.to_owned()));
        }
        if file.is_given(field!("element.memory")) && settings.has_memory {
            let reason = "the force element of a wheel with two profiles has none";
            return Err(self.contradiction(field!("element.memory"), reason));
        }
        for field in fields!["element.motion", "element.normal"] {
            if file.is_given(field) {
                let reason = "the force element of a wheel with two profiles takes its pose and \
                              velocities";
                return Err(self.contradiction(field, reason));
            }
        }
        let (name, bytes) = file.read_file(TABLE)?;
        let table = contact_table::from_bytes(&bytes, &self.wanted_contacts(wheel))
            .map_err(|error| file.error(TABLE, format!("{TABLE}: {name} {error}")))?;
        let Position { lateral, roll, yaw } = found.position;
        let motion = Motion { angular_velocity: found.angular_velocity, ..wheel.motion };
        let parts = WheelParts {
            table,
            side: wheel.side,
            pose: [lateral, found.height, roll, yaw],
            motion,
            interface: &self.problem.interface,
        };
        Element::of_wheel(parts, &self.method, settings).map_err(|error| self.explain(&error))
    }

    /// What a table of the contacts of a wheel is for.
    fn wanted_contacts<'a>(&self, wheel: &'a WheelOnRail) -> Wanted<'a> {
        Wanted {
            pair: wheel.pairs.of(wheel.side),
            contact_modulus: self.problem.interface.contact_modulus(),
            joining: wheel.joining,
        }
    }

    /// The table of the contacts of its wheel with two profiles, and its errors in random poses.
    ///
    /// # Errors
    /// A case without two profiles, profiles that change along the way, a roller, an interruption.
    pub fn contact_table(
        &self,
        options: &ContactTableOptions,
        watch: Watch,
    ) -> Result<(ContactTable, ContactTableErrors), CaseError> {
        let Some(solver) = &self.wheel_solver else {
            let reason = "a table of contacts is of a wheel with two profiles, \"wheel-rail\"";
            return Err(self.contradiction(field!("normal.model"), reason));
        };
        let Wanted { pair, contact_modulus, joining } =
            self.wanted_contacts(solver.request.wheel());
        let made = ContactTable::build(pair, (contact_modulus, joining), options, watch);
        made.map_err(|error| self.explain(&error))
    }
}
