//! What there is to choose from.

/// One of several names.
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// The name.
    pub name: &'static str,
    /// What it stands for.
    pub doc: &'static str,
}

/// The type of a field that is one of several names.
pub trait Choose: Copy + Send + Sync + 'static {
    /// The names, in the order of [`Self::ALL`].
    const CHOICES: &'static [Choice];
    /// What they stand for.
    const ALL: &'static [Self];

    /// What a name stands for.
    fn named(name: &str) -> Option<Self> {
        let index = Self::CHOICES.iter().position(|choice| choice.name == name)?;
        Self::ALL.get(index).copied()
    }
}

macro_rules! choices {
    ($($(#[$meta:meta])* $name:ident { $($variant:ident $text:literal $doc:expr;)+ })+) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name {
            $(#[doc = concat!("`", $text, "`.")] $variant,)+
        }

        impl $name {
            /// Its name in a case file.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $text),+ }
            }
        }

        impl Choose for $name {
            const CHOICES: &'static [Choice] = &[$(Choice { name: $text, doc: $doc }),+];
            const ALL: &'static [Self] = &[$(Self::$variant),+];
        }
    )+};
}

const EXPONENTIAL: &str = "μ = μ_kin + μ1 2^(−s/s1) + μ2 2^(−s/s2), μ1 = μ0 − μ_kin − μ2";
const RATIONAL: &str = "μ = μ_kin + μ1/(1 + s/s1) + μ2/(1 + (s/s2)²), μ1 = μ0 − μ_kin − μ2";
const LINEAR_IN_SPEED: &str =
    "μ = μ_kin + μ1 max(0, 1 − s/2s1) + μ2 max(0, 1 − s/2s2), μ1 = μ0 − μ_kin − μ2";
const POLACH: &str = "μ = μ0 ((1 − A) e^(−B s) + A), Polach 2005";

choices! {
    /// `kinematics.reference`.
    Reference {
        Patch "patch" "the middle of the patch";
        File "file" "the origin of the positions in normal.file";
    }

    /// `normal.model`.
    NormalModel {
        Hertz "hertz" "from the radii and the moduli of both bodies, and load or approach";
        Line "line"
            "from the radii along rolling and the moduli of two cylinders, length, and load or approach";
        Ellipse "ellipse" "from semi_axis_x, semi_axis_y, and load or peak_pressure";
        Tabulated "tabulated" "from file, scaled to load if that is given";
        Profile "profile" "from file, the undeformed distance of the bodies, and load or approach";
        WheelRail "wheel-rail"
            "from wheel.profile, rail.profile, track, wheelset, and load, the vertical force: all \
             contacts of a wheel";
    }

    /// `wheel.profile_z` and `rail.profile_z`.
    VerticalAxis {
        Auto "auto" "found from the shape (what runs is level, sides and flange hang down), else that of the format";
        Up "up" "upwards";
        Down "down" "downwards";
    }

    /// `wheel.profile_y` and `rail.profile_y`.
    LateralAxis {
        Auto "auto" "found from the flange of a wheel and the deeper side of a rail, else that of the format";
        Outwards "outwards" "away from the middle of the track";
        Inwards "inwards" "towards the middle of the track";
    }

    /// `normal.row_motion`.
    RowMotion {
        Automatic "automatic"
            "plane where the surface turns by up to 0.2 rad over a contact, surface from 0.3 rad on";
        Surface "surface" "every row slips and spins as the surface there";
        Plane "plane" "all rows move with the plane of the contact";
    }

    /// `normal.method`.
    NormalSolution {
        HalfSpaces "half-spaces" "the pressure of two elastic half-spaces";
        Conformal "conformal"
            "the same on the curved surface of the rail, for contacts that turn by more than 0.3 rad";
        KikPiotrowski "kik-piotrowski"
            "patch and pressure from the overlap at 0.55 of the approach (virtual penetration)";
        EllipseCorrected "ellipse-corrected"
            "the same with shares of the approach from Hertz's theory, exact for ellipses";
        EquivalentEllipse "equivalent-ellipse" "Hertz's ellipse with the curvatures of the distance";
        Analyn "analyn" "row by row as in Hertz's ellipse with the curvatures there";
    }

    /// `wheelset.side`.
    WheelSide {
        Right "right" "the wheel at negative y";
        Left "left" "the wheel at positive y";
    }

    /// `wheelset.force_axis`.
    ForceAxis {
        Track "track" "along the track";
        Wheelset "wheelset" "across the axle: it turns with the wheelset";
    }

    /// `elasticity.model`.
    ElasticityModel {
        ElasticLayer "elastic-layer" "a bed of springs, each coupled with its neighbours";
        HalfSpace "half-space" "Boussinesq and Cerruti: exact for bodies that are large compared with the patch";
        Viscoelastic "viscoelastic" "half-spaces of standard linear solids in steady rolling, which change the pressure of \"hertz\", \"line\" and \"profile\", too";
        Winkler "winkler" "a bed of springs without coupling";
        Rigid "rigid" "no deformation: the slip is prescribed";
    }

    /// `elasticity.calibration`.
    CalibratedWith {
        HalfSpace "half-space"
            "stiffnesses with which the springs answer like the half-space on the same patch in steady \
             rolling; without coupling those of Kalker 1982";
    }

    /// `elasticity.unlike_bodies`.
    UnlikeBodiesModel {
        Coupled "coupled"
            "pressure displaces the surfaces tangentially, and tractions change the pressure of \
             \"hertz\", \"line\" and \"profile\"";
        OneWay "one-way" "pressure displaces the surfaces tangentially, but does not change";
        Neglected "neglected" "neither";
    }

    /// `contact_law.model`.
    ContactLawModel {
        Incremental "incremental" "valid for any path of sliding";
        TotalDisplacement "total-displacement"
            "Neuhaus and Sextro 2014, for sliding in one direction";
        Coulomb "coulomb"
            "no sliding at all up to μ pₙ, the limit k_c → ∞";
    }

    /// `contact_law.roughness.form`.
    FormTakenOff {
        Plane "plane" "a tilted plane";
        Cylinder "cylinder" "a circular cylinder in any direction";
        Sphere "sphere" "a sphere";
        Nothing "none" "nothing";
    }

    /// `friction.model`.
    FrictionModel {
        TemperatureLinear "temperature-linear" "μ = μ0 (1 − T/T_E), at least minimum_coefficient";
        Constant "constant" "μ = μ0";
        TemperaturePiecewiseLinear "temperature-piecewise-linear"
            "μ = μ0 up to T = 0, linear to μ_hot at T = ΔT, μ_hot beyond";
        Exponential "exponential" EXPONENTIAL;
        Rational "rational" RATIONAL;
        LinearInSpeed "linear-in-speed" LINEAR_IN_SPEED;
        Polach "polach" POLACH;
    }

    /// `friction.speed_model`.
    SpeedModel {
        Nothing "none" "friction does not depend on the slip speed";
        Exponential "exponential" EXPONENTIAL;
        Rational "rational" RATIONAL;
        LinearInSpeed "linear-in-speed" LINEAR_IN_SPEED;
        Polach "polach" POLACH;
    }

    /// `heat.model`.
    HeatChoice {
        Duhamel "duhamel" "each cell cools after it was heated";
        ConstantSource "constant-source" "Neuhaus and Sextro 2014: never cools";
        Nothing "none" "no heating";
    }

    /// `heat.partition`, where it is no number.
    PartitionChoice {
        Velocity "velocity" "from speeds and effusivities of both bodies";
    }

    /// `subsurface.body`.
    BodyChoice {
        Rail "rail" "the rail";
        Wheel "wheel" "the wheel";
    }

    /// `solver.driver`: how the full equations are solved.
    DriverChoice {
        Steady "steady" "the steady state directly";
        Marching "marching" "step by step in time: to the steady state, or along a history";
    }

    /// `history.start`.
    StartChoice {
        Rest "rest" "no tangential tractions";
        Steady "steady" "steady rolling with the values of the first instant";
    }

    /// `solver.branch`.
    BranchChoice {
        LowSlip "low-slip" "the state that is reached when the creepages grow from zero";
        HighSlip "high-slip" "the state that is reached when larger creepages fall";
    }

    /// `solver.method`.
    MethodChoice {
        Full "full" "the coupled equations";
        KalkerLinear "kalker-linear" "Kalker's linear theory: forces for small creepages";
        ShenHedrickElkins "shen-hedrick-elkins" "Shen, Hedrick and Elkins 1983: forces";
        Polach "polach" "Polach 1999 and 2005: forces, with k_A and k_S";
        Table "table" "a look-up table of the half-space with Coulomb's law: forces";
        Fastsim "fastsim" "Kalker 1982: bristles without coupling, with heat";
        ModifiedFastsim "modified-fastsim"
            "Spiryagin, Polach and Cole 2013: FASTSIM with a slope that falls with the creepage";
    }

    /// `element.motion`.
    ElementMotion {
        Velocities "velocities"
            "v_x, v_y, ω and spin rate: slip (v_x − ωR, v_y, ω_z), speed (v_x + ωR)/2";
        Creepages "creepages" "ξ, η, φ and the speed";
    }

    /// `element.normal`.
    ElementNormal {
        Load "load" "the normal load";
        Approach "approach" "the approach of the bodies, of given radii";
    }

    /// `fastsim.flexibilities`.
    FlexibilitiesChoice {
        Three "three" "one each for longitudinal, lateral and spin creepage";
        One "one" "their mean, weighted with the creepages";
    }

    /// `fastsim.bound`.
    BoundChoice {
        Parabolic "parabolic" "μ 2N/(πab) (1 − x²/a² − y²/b²)";
        Elliptic "elliptic" "μ p_n: the pressure of Hertz, or of a table";
    }
}
