//! The quantities of a rolling contact: inputs and results, each defined once.
//!
//! Errors, warnings and columns of results refer to a quantity by this type. Each interface has its
//! own names for them, such as a path in a case file, an option or a keyword: see
//! [`Words`](crate::reporting::Words).

macro_rules! quantities {
    ($($variant:ident $name:literal $symbol:literal $unit:literal $description:literal)*) => {
        /// A quantity.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Quantity {
            $(#[doc = concat!($description, ", `", $name, "`.")] $variant),*
        }

        impl Quantity {
            /// All quantities: inputs first, then those that only results have.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Name: a word in lower case with underscores, the same in every version.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),* }
            }

            /// Symbol; empty if it has none.
            pub fn symbol(self) -> &'static str {
                match self { $(Self::$variant => $symbol),* }
            }

            /// SI unit, temperatures in degC; empty if dimensionless.
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$variant => $unit),* }
            }

            /// Short description.
            pub fn description(self) -> &'static str {
                match self { $(Self::$variant => $description),* }
            }
        }
    };
}

quantities! {
    Speed "speed" "v0" "m/s" "speed of the vehicle, or of the contact frame"
    CreepageX "creepage_x" "ξ" "" "longitudinal creepage"
    CreepageY "creepage_y" "η" "" "lateral creepage"
    Spin "spin" "φ" "1/m" "spin creepage"
    Creepage "creepage" "ν" "" "total creepage"
    Direction "direction" "θ" "rad" "direction of the total creepage, from x towards y"
    Reference "reference" "" "" "point at which creepages hold and about which moments are taken"
    WheelYoungModulus "wheel_young_modulus" "E" "Pa" "Young's modulus of the wheel"
    WheelRelaxedModulus "wheel_relaxed_modulus" "E∞" "Pa" "relaxed Young's modulus of the wheel"
    WheelRetardationTime "wheel_retardation_time" "τ" "s" "retardation time of the wheel"
    WheelPoissonRatio "wheel_poisson_ratio" "ν" "" "Poisson's ratio of the wheel"
    WheelConductivity "wheel_conductivity" "λ" "W/(m K)" "thermal conductivity of the wheel"
    WheelDensity "wheel_density" "ρ" "kg/m^3" "density of the wheel"
    WheelSpecificHeat "wheel_specific_heat" "c" "J/(kg K)" "specific heat of the wheel"
    WheelBulkTemperature "wheel_bulk_temperature" "T_w" "degC" "bulk temperature of the wheel"
    WheelRadiusX "wheel_radius_x" "R_x" "m" "radius of curvature of the wheel along rolling"
    WheelRadiusY "wheel_radius_y" "R_y" "m" "radius of curvature of the wheel across rolling"
    RailYoungModulus "rail_young_modulus" "E" "Pa" "Young's modulus of the rail"
    RailRelaxedModulus "rail_relaxed_modulus" "E∞" "Pa" "relaxed Young's modulus of the rail"
    RailRetardationTime "rail_retardation_time" "τ" "s" "retardation time of the rail"
    RailPoissonRatio "rail_poisson_ratio" "ν" "" "Poisson's ratio of the rail"
    RailConductivity "rail_conductivity" "λ" "W/(m K)" "thermal conductivity of the rail"
    RailDensity "rail_density" "ρ" "kg/m^3" "density of the rail"
    RailSpecificHeat "rail_specific_heat" "c" "J/(kg K)" "specific heat of the rail"
    RailBulkTemperature "rail_bulk_temperature" "T_r" "degC" "bulk temperature of the rail"
    RailRadiusX "rail_radius_x" "R_x" "m" "radius of curvature of the rail along rolling"
    RailRadiusY "rail_radius_y" "R_y" "m" "radius of curvature of the rail across rolling"
    WheelProfile "wheel_profile" "" "m" "profile of the wheel"
    RailProfile "rail_profile" "" "m" "profile of the rail"
    ProfileSmoothing "profile_smoothing" "L" "m" "length over which a profile is smoothed"
    FlangeBackPosition "flange_back_position" "y_fb" "m" "position of the flange back in the wheel's profile"
    RailCant "rail_cant" "" "" "inclination of the rail towards the middle of the track"
    RailOrigin "rail_origin" "" "m" "position of the origin of the rail's profile in the track"
    RailDeviation "rail_deviation" "" "m" "deviation of the rail from its place"
    WheelDeviation "wheel_deviation" "" "m" "deviation of the wheel from its place"
    CurveRadius "curve_radius" "R" "m" "radius of the curve of the track"
    Gauge "gauge" "" "m" "track gauge"
    GaugeDepth "gauge_depth" "" "m" "depth below the top of the rail at which the gauge is measured"
    FlangeBackDistance "flange_back_distance" "" "m" "distance between the flange backs of a wheelset"
    JoinDistance "join_distance" "" "m" "distance below which neighbouring contacts share one plane"
    RowMotion "row_motion" "" "" "with what the rows of a contact move"
    JoinAngle "join_angle" "" "rad" "difference of angles below which neighbouring contacts share one plane"
    WheelSide "wheel_side" "" "" "side of the wheelset"
    LateralPosition "lateral_position" "y_ws" "m" "lateral position of the wheelset"
    WheelsetHeight "wheelset_height" "z_ws" "m" "height of the axle above the nominal radius over z = 0 of the track"
    WheelsetYaw "wheelset_yaw_angle" "ψ_ws" "rad" "yaw angle of the wheelset"
    RollAngle "roll_angle" "φ_ws" "rad" "roll angle of the wheelset"
    LateralVelocity "lateral_velocity" "v_y" "m/s" "lateral velocity of the wheelset"
    VerticalVelocity "vertical_velocity" "v_z" "m/s" "vertical velocity of the wheelset"
    YawRate "yaw_rate" "" "rad/s" "yaw rate of the wheelset"
    RollRate "roll_rate" "" "rad/s" "roll rate of the wheelset"
    AngularVelocity "angular_velocity" "ω" "rad/s" "angular velocity of the wheel about its axle"
    ForceOverLoad "force_over_load" "-F_x/N" "" "longitudinal force over the load, positive in braking"
    VelocityX "velocity_x" "v_x" "m/s" "forward velocity of the wheel's centre"
    VelocityY "velocity_y" "v_y" "m/s" "lateral velocity of the wheel over the rail at the contact"
    SpinRate "spin_rate" "ω_z" "rad/s" "angular velocity of the wheel over the rail about the normal"
    FrictionFactor "friction_factor" "" "" "factor of the coefficient of friction"
    StandstillSpeed "standstill_speed" "v_s" "m/s" "speed below which slip is no longer divided by the rolling speed"
    ElasticShiftX "elastic_shift_x" "u_x" "m" "elastic shift of the wheel over the rail along rolling"
    ElasticShiftY "elastic_shift_y" "u_y" "m" "elastic shift of the wheel over the rail across rolling"
    ElasticTurn "elastic_turn" "u_φ" "rad" "elastic turn of the wheel over the rail about the normal"
    RailDisplacementY "rail_displacement_y" "" "m" "lateral displacement of the rail, to the left"
    RailDisplacementZ "rail_displacement_z" "" "m" "vertical displacement of the rail, upwards"
    RailVelocityY "rail_velocity_y" "" "m/s" "lateral velocity of the rail"
    RailVelocityZ "rail_velocity_z" "" "m/s" "vertical velocity of the rail"
    WheelTorque "wheel_torque" "T" "N m" "torque on the wheel about its axle, positive where it drives"
    PoissonRatio "poisson_ratio" "ν" "" "combined Poisson's ratio of both bodies"
    Load "load" "N" "N" "normal load"
    PeakPressure "peak_pressure" "p0" "Pa" "largest pressure"
    SemiAxisX "semi_axis_x" "a" "m" "half the length of the patch along rolling"
    SemiAxisY "semi_axis_y" "b" "m" "half the width of the patch across rolling"
    LineLength "line_length" "L" "m" "length of the line contact across rolling"
    AxisRatio "axis_ratio" "a/b" "" "length of the patch over its width"
    LookUpTable "look_up_table" "" "" "look-up table of the forces"
    ContactTable "contact_table" "" "" "table of the contacts of a wheel on a rail"
    PressureTable "pressure_table" "p" "Pa" "table of the normal pressure"
    UndeformedDistance "undeformed_distance" "h" "m" "distance between the undeformed bodies"
    NormalCells "normal_cells" "" "" "cells across the patch of the normal contact"
    RandomPoses "random_poses" "" "" "random poses in which errors are measured"
    LayerThickness "layer_thickness" "h" "m" "thickness of the layer between the surfaces"
    LayerShearModulus "layer_shear_modulus" "G" "Pa" "shear modulus of the layer between the surfaces"
    LayerYieldStress "layer_yield_stress" "τ_c0" "Pa" "traction at which the layer between the surfaces yields"
    LayerHardening "layer_hardening" "k_τ" "N/m^3" "growth of that with the plastic displacement of the layer"
    BeddingX "bedding_x" "c_x" "N/m^3" "bedding of the layer along rolling"
    BeddingY "bedding_y" "c_y" "N/m^3" "bedding of the layer across rolling"
    CouplingX "coupling_x" "g_x" "N/m" "coupling of displacements along rolling, in that direction"
    CouplingXAcross "coupling_x_across" "g_x" "N/m" "coupling of displacements along rolling, across it"
    CouplingY "coupling_y" "g_y" "N/m" "coupling of displacements across rolling, along it"
    CouplingYAcross "coupling_y_across" "g_y" "N/m" "coupling of displacements across rolling, across it"
    SpringX "spring_x" "Δc_x" "N/m" "spring of an element along rolling"
    SpringY "spring_y" "Δc_y" "N/m" "spring of an element across rolling"
    SpringCouplingX "spring_coupling_x" "Δc_kx" "N/m" "spring between elements along rolling"
    SpringCouplingY "spring_coupling_y" "Δc_ky" "N/m" "spring between elements across rolling"
    Margin "margin" "" "m" "margin of the layer around the patch"
    Elasticity "elasticity" "" "" "model of elasticity"
    Calibration "calibration" "" "" "source of the stiffnesses of the layer"
    UnlikeBodies "unlike_bodies" "" "" "coupling of pressure and tractions of unlike bodies"
    ContactLaw "contact_law" "" "" "law for the traction of a point that slides"
    ContactStiffness "contact_stiffness" "k_c" "1/m" "stiffness of the contact law"
    ContactRoughness "contact_roughness" "h_rms" "m" "r.m.s. height of both surfaces together, which determines k_c"
    FrictionModel "friction_model" "" "" "law of friction"
    FrictionCoefficient "friction_coefficient" "μ0" "" "coefficient of friction, cold and without slip"
    TemperatureAtZeroFriction "temperature_at_zero_friction" "T_E" "K" "temperature rise at which friction vanishes"
    MinimumCoefficient "minimum_coefficient" "μ_min" "" "lower limit of the coefficient of friction"
    HotCoefficient "hot_coefficient" "μ_hot" "" "coefficient of friction of the hot contact"
    TemperatureRange "temperature_range" "ΔT" "K" "temperature range over which friction falls"
    KineticCoefficient "kinetic_coefficient" "μ_kin" "" "coefficient of friction at large slip speed"
    HalfSpeed "half_speed" "s1" "m/s" "slip speed at which the first term has halved"
    SecondCoefficient "second_coefficient" "μ2" "" "size of the second term of friction"
    SecondHalfSpeed "second_half_speed" "s2" "m/s" "slip speed at which the second term has halved"
    LimitRatio "limit_ratio" "A" "" "friction at large slip speed over that without slip"
    Decay "decay" "B" "s/m" "decay of friction with the slip speed"
    ReferenceTemperature "reference_temperature" "T_0" "degC" "temperature at which friction is cold"
    MemoryDistance "memory_distance" "" "m" "sliding distance over which friction approaches its law"
    MemorySpeed "memory_speed" "" "m/s" "smallest slip speed of the friction memory"
    VariationY "variation_y" "y" "m" "positions across rolling at which friction varies"
    VariationInclination "variation_inclination" "α" "rad" "inclinations of the rail at which friction varies"
    VariationFactor "variation_factor" "" "" "factors of friction across rolling"
    HeatModel "heat_model" "" "" "model of heat conduction"
    HeatPartition "heat_partition" "" "" "part of the heat that the wheel takes"
    Time "time" "t" "s" "time"
    HistorySpeed "speed_history" "v0" "m/s" "speed over time"
    HistoryCreepageX "creepage_x_history" "ξ" "" "longitudinal creepage over time"
    HistoryCreepageY "creepage_y_history" "η" "" "lateral creepage over time"
    HistorySpin "spin_history" "φ" "1/m" "spin creepage over time"
    HistoryLoad "load_history" "N" "N" "normal load over time"
    HistoryForceX "force_x_history" "F_x" "N" "longitudinal force over time"
    HistoryForceY "force_y_history" "F_y" "N" "lateral force over time"
    HistoryMomentZ "moment_z_history" "M_z" "N m" "spin moment over time"
    HistoryShiftX "shift_x_history" "" "m" "shifts along rolling"
    HistoryShiftY "shift_y_history" "" "m" "shifts across rolling"
    HistoryTurn "turn_history" "" "rad" "turns about z"
    ShiftX "shift_x" "" "m" "shift of the wheel over the rail at rest, along rolling"
    ShiftY "shift_y" "" "m" "shift of the wheel over the rail at rest, across rolling"
    Turn "turn" "" "rad" "turn of the wheel over the rail at rest, about z"
    ShiftDuration "shift_duration" "" "s" "how long the motion of a wheelset acts in a shift"
    CellsX "cells_x" "" "" "cells along rolling"
    CellsY "cells_y" "" "" "cells across rolling"
    Method "method" "" "" "which equations are solved"
    Driver "driver" "" "" "how the steady state is computed"
    Branch "branch" "" "" "which of several steady states is computed"
    Tolerance "tolerance" "" "" "relative tolerance"
    MaxIterations "max_iterations" "" "" "largest number of Newton steps"
    MaxSteps "max_steps" "" "" "largest number of time steps"
    SlipThreshold "slip_threshold" "" "" "part of the friction limit above which a cell counts as sliding"
    Sensitivities "sensitivity" "" "" "derivatives of the forces"
    Extrapolate "extrapolate" "" "" "forces extrapolated from two grids"
    InitialState "initial_state" "" "" "state to start from"
    PolachAreaAdhesion "polach_area_adhesion" "k_A" "" "Polach's reduction in the area of adhesion"
    PolachAreaSlip "polach_area_slip" "k_S" "" "Polach's reduction in the area of slip"
    InitialReduction "initial_reduction" "k0" "" "reduction of FASTSIM's slope at small creepages"
    ReductionLimitRatio "reduction_limit_ratio" "α" "" "fraction of that reduction at large creepages"
    ReductionDecay "reduction_decay" "β" "" "decay of that reduction with creepage"
    TractionBound "traction_bound" "" "" "pressure that bounds the traction of FASTSIM"
    FilmCoefficient "film_coefficient" "h" "W/(m^2 K)" "film coefficient of the wheel's surface"
    CooledArea "cooled_area" "A" "m^2" "area of the wheel that the air cools"
    AirTemperature "air_temperature" "T_a" "degC" "temperature of the air"
    WaveNumber "wave_number" "q" "rad/m" "wave number"
    SpectralDensity "spectral_density" "C" "m^4" "power spectral density of the heights"
    Gap "gap" "g" "m" "gap of the surfaces; negative where the material has yielded"
    Heights "heights" "z" "m" "heights of a surface"
    SpacingX "spacing_x" "" "m" "spacing of the points of a surface along x"
    SpacingY "spacing_y" "" "m" "spacing of the points of a surface along y"
    Columns "columns" "" "" "columns of a surface"
    Rows "rows" "" "" "rows of a surface"
    RmsHeight "rms_height" "h_rms" "m" "root mean square height"
    RmsSlope "rms_slope" "h'_rms" "" "root mean square gradient"
    HurstExponent "hurst_exponent" "H" "" "Hurst exponent"
    LongestWavelength "longest_wavelength" "λ_l" "m" "longest wavelength"
    RollOffWavelength "roll_off_wavelength" "λ_r" "m" "wavelength of the roll-off"
    ShortestWavelength "shortest_wavelength" "λ_s" "m" "shortest wavelength"
    CutoffWavelength "cutoff_wavelength" "λ_c" "m" "cut-off wavelength of the filter"
    Form "form" "" "" "form removed from a surface"
    MeanPressure "mean_pressure" "p" "Pa" "mean pressure on a rough surface"
    Hardness "hardness" "H" "Pa" "hardness of the softer body"
    ShearYieldStress "shear_yield_stress" "k" "Pa" "yield stress in pure shear"
    WearHardness "wear_hardness" "H" "Pa" "hardness of the softer body in Archard's law of wear"
    WearCoefficientMild "wear_coefficient_mild" "k" "" "coefficient of Archard's law for mild wear"
    WearCoefficientSevere "wear_coefficient_severe" "k" "" "coefficient of Archard's law for severe wear"
    WearCoefficientCatastrophic "wear_coefficient_catastrophic" "k" "" "coefficient of Archard's law for catastrophic wear"
    WearCoefficient "wear_coefficient" "k" "" "coefficient of Archard's law"
    CrackWearNumber "crack_t_gamma" "Tγ" "N" "wear number at a point of the function of cracks"
    MeltingTemperature "melting_temperature" "T_m" "degC" "temperature from which on the surfaces melt"
    WearRateMild "wear_rate_mild" "" "kg/J" "mass worn per energy, mild wear"
    WearRateCatastrophic "wear_rate_catastrophic" "" "kg/J" "mass worn per energy beyond severe wear"
    CurvePoints "points" "" "" "points of a creep curve"
    FitParameters "parameters" "" "" "parameters to be fitted"
    ForceRatio "force_ratio" "F/N" "" "tangential force on the rail over the load"
    StandardDeviation "standard_deviation" "σ" "" "standard deviation of a force ratio"
    SlopeFactor "slope_factor" "γ" "" "approach of rough surfaces over their height for an e-fold pressure"
    Samples "samples" "" "" "known displacements"
    SampleTraction "traction" "t" "Pa" "traction of known displacements"
    SampleDisplacement "displacement" "u" "m" "known displacements"

    X "x" "x" "m" "position along rolling"
    Y "y" "y" "m" "position across rolling"
    Covered "covered" "" "" "fraction of the cell in contact"
    Pressure "pressure" "p" "Pa" "normal pressure"
    TractionX "traction_x" "t_x" "Pa" "traction along rolling"
    TractionY "traction_y" "t_y" "Pa" "traction across rolling"
    SlipX "slip_x" "s_x" "m/s" "slip velocity of the wheel over the rail along rolling"
    SlipY "slip_y" "s_y" "m/s" "slip velocity of the wheel over the rail across rolling"
    DisplacementX "displacement_x" "u_x" "m" "displacement of wheel minus rail along rolling"
    DisplacementY "displacement_y" "u_y" "m" "displacement of wheel minus rail across rolling"
    Friction "friction" "μ" "" "coefficient of friction in effect"
    FrictionPowerDensity "friction_power_density" "q" "W/m^2" "frictional power density"
    RiseWheel "temperature_rise_wheel" "ΔT_w" "K" "temperature rise of the wheel's surface"
    RiseRail "temperature_rise_rail" "ΔT_r" "K" "temperature rise of the rail's surface"
    Sliding "sliding" "" "" "whether the cell slides"
    ForceX "force_x" "F_x" "N" "longitudinal force"
    ForceY "force_y" "F_y" "N" "lateral force"
    MomentZ "moment_z" "M_z" "N m" "spin moment"
    NormalisedX "normalised_x" "F_x/(μ0 N)" "" "longitudinal force over the friction limit"
    NormalisedY "normalised_y" "F_y/(μ0 N)" "" "lateral force over the friction limit"
    NormalisedMomentZ "normalised_moment_z" "M_z/(μ0 N √(ab))" "" "moment over friction limit and size"
    TractionCoefficient "traction_coefficient" "|F|/N" "" "tangential force over the load"
    FrictionPower "friction_power" "P" "W" "friction power"
    CreepPower "creep_power" "P_c" "W" "power of the creep forces"
    ReturnedPower "returned_power" "" "W" "friction power that the bristles of the contact law return"
    HeatIntoWheel "heat_into_wheel" "" "W" "part of the heat that goes into the wheel"
    HeatIntoRail "heat_into_rail" "" "W" "part of the heat that goes into the rail"
    HeatExchanged "heat_exchanged" "" "W" "heat from the wheel into the rail as their bulk temperatures differ"
    WearNumber "t_gamma" "Tγ" "N" "wear number, frictional energy per distance rolled"
    FatigueIndex "fatigue_index" "FI" "" "surface-fatigue index; fatigue begins where it is positive"
    SlipSpeed "slip_speed" "s" "m/s" "mean slip speed of the patch, weighted by the pressure"
    StressXx "stress_xx" "σ_xx" "Pa" "normal stress along rolling, tension positive"
    StressYy "stress_yy" "σ_yy" "Pa" "normal stress across rolling, tension positive"
    StressZz "stress_zz" "σ_zz" "Pa" "normal stress perpendicular to the surface, tension positive"
    StressXy "stress_xy" "σ_xy" "Pa" "shear stress in the planes of x and y"
    StressXz "stress_xz" "σ_xz" "Pa" "shear stress in the planes of x and z, z up"
    StressYz "stress_yz" "σ_yz" "Pa" "shear stress in the planes of y and z, z up"
    VonMisesStress "von_mises_stress" "σ_v" "Pa" "equivalent stress of von Mises"
    LargestShearStress "largest_shear_stress" "τ_max" "Pa" "largest shear stress over all planes"
    LargestPrincipalStress "largest_principal_stress" "σ_1" "Pa" "largest principal stress"
    HydrostaticStress "hydrostatic_stress" "σ_m" "Pa" "mean of the normal stresses"
    DissipatedEnergy "dissipated_energy" "E" "J" "energy dissipated by friction since the start"
    CrackDamage "crack_damage" "" "" "damage by cracks: reciprocal of the number of passages until one is there"
    LocalSlipSpeed "local_slip_speed" "s" "m/s" "slip speed"
    PressureRatio "pressure_ratio" "p/H" "" "pressure over the hardness"
    WearRateArchard "archard_wear_rate" "" "" "depth worn per distance in the contact, by Archard's law"
    WearRateEnergy "energy_wear_rate" "" "kg/m^3" "mass worn per area and distance in the contact, by energy"
    WearDepth "wear_depth" "h" "m" "depth of wear"
    WearVolume "wear_volume" "" "m^2" "volume worn from each body per distance rolled"
    WearMass "wear_mass" "" "kg/m" "mass worn from each body per distance rolled"
    PecletNumber "peclet" "v a/κ" "" "Péclet number"
    StoredEnergy "stored_energy" "E" "J" "elastic energy of the tangential deformation"
    Distance "distance" "s" "m" "distance rolled"
    MaxRise "max_rise" "ΔT" "K" "largest temperature rise"
    MaxRiseWheel "max_rise_wheel" "ΔT_w" "K" "largest temperature rise of the wheel's surface"
    MaxRiseRail "max_rise_rail" "ΔT_r" "K" "largest temperature rise of the rail's surface"
    MaxTemperatureWheel "max_temperature_wheel" "T_w" "degC" "largest temperature of the wheel's surface"
    MaxTemperatureRail "max_temperature_rail" "T_r" "degC" "largest temperature of the rail's surface"
    WheelTemperature "temperature_wheel" "T_w" "degC" "temperature of the wheel"
    RailTemperature "temperature_rail" "T_r" "degC" "temperature of the rail"
    Depth "depth" "z" "m" "depth below the surface"
    ContactArea "contact_area" "A" "m^2" "area of contact"
    StickArea "stick_area" "" "m^2" "stick area"
    SlipArea "slip_area" "" "m^2" "slip area"
    Residual "residual" "" "" "relative residual"
    Strategy "strategy" "" "" "what led to the solution: warm, cold, continuation or march"
    NewtonIterations "newton_iterations" "" "" "Newton steps"
    OperatorProducts "operator_products" "" "" "number of products with the compliance"
    ComputingTime "computing_time" "" "s" "computing time with set-up"
    ComputingTimeAgain "computing_time_again" "" "s" "computing time without set-up"
    FittedRatio "fitted" "F/N" "" "fitted force over the load"
    RatioResidual "ratio_residual" "" "" "measured minus fitted force over the load"
    Approach "approach" "d" "m" "approach of the bodies"
    ContactFraction "contact_fraction" "A/A0" "" "real over nominal area of contact"
    CorrectedContactFraction "corrected_contact_fraction" "" "" "real over nominal area of contact, corrected for the perimeter"
    SpotPressure "spot_pressure" "" "Pa" "largest pressure in a spot"
    PlasticFraction "plastic_fraction" "" "" "fraction of the nominal area that has yielded"
    Iterations "iterations" "" "" "iterations of a solution"
    Component "component" "" "" "component of a measured force"
    Convergence "convergence" "" "" "whether the equations hold to the tolerance"
    MeanGap "mean_gap" "" "m" "mean gap of the surfaces"
    SurfaceDisplacement "surface_displacement" "u" "m" "tangential displacement of rough surfaces"
    SurfaceTraction "surface_traction" "t" "Pa" "mean traction on rough surfaces"
    NormalisedTraction "normalised_traction" "t/(μp)" "" "traction over the friction limit"
    NormalisedDisplacement "normalised_displacement" "" "" "displacement over that of full sliding"
    TangentialStiffness "tangential_stiffness" "" "Pa/m" "tangential stiffness per area"
    MicroSlip "micro_slip" "" "m" "slip of the spots"
    SlidingFraction "sliding_fraction" "" "" "sliding fraction of the real contact"
    PositionX "position_x" "x" "m" "position in the track, forwards of the wheelset's centre"
    PositionY "position_y" "y" "m" "position in the track, to the left of its middle"
    PositionZ "position_z" "z" "m" "position in the track, upwards"
    ContactAngle "contact_angle" "δ" "rad" "angle of the contact plane, positive where the rail's outward normal leans to the left"
    RiseAngle "rise_angle" "θ" "rad" "angle by which the contact plane rises forwards, with the rail"
    ContactCount "contact_count" "" "" "number of contacts of a wheel"
    ContactNumber "contact_number" "" "" "number of a contact of a wheel, by its normal force"
    RailPosition "rail_position" "y_r" "m" "position of the contact on the rail's profile, outwards"
    WheelPosition "wheel_position" "y_w" "m" "position of the contact on the wheel's profile, outwards"
    RollingRadius "rolling_radius" "r" "m" "radius of the wheel at the contact"
    RollingRadiusDifference "rolling_radius_difference" "Δr" "m" "rolling radius of the left wheel minus that of the right one"
    RigidRollingRadiusDifference "rigid_rolling_radius_difference" "Δr" "m" "the same of rigid bodies that neither roll about x nor yaw"
    EquivalentConicity "equivalent_conicity" "tan γ_e" "" "equivalent conicity by the wavelength of the nonlinear motion (EN 15302)"
    HarmonicConicity "harmonic_conicity" "tan γ_h" "" "equivalent conicity by harmonic linearisation"
    Amplitude "amplitude" "ŷ" "m" "amplitude of the lateral motion"
    ForceErrorX "force_error_x" "ΔF_x" "N" "estimated error of the longitudinal force"
    ForceErrorY "force_error_y" "ΔF_y" "N" "estimated error of the lateral force"
    MomentErrorZ "moment_error_z" "ΔM_z" "N m" "estimated error of the moment"
    WheelForceX "wheel_force_x" "F_x" "N" "longitudinal force on the wheel in the track frame"
    WheelForceY "wheel_force_y" "F_y" "N" "lateral force on the wheel in the track frame"
    WheelForceZ "wheel_force_z" "F_z" "N" "vertical force on the wheel in the track frame"
    WheelMomentX "wheel_moment_x" "M_x" "N m" "moment on the wheel about the middle of the axle, along the track"
    WheelMomentY "wheel_moment_y" "M_y" "N m" "moment on the wheel about the middle of the axle, to the left"
    WheelMomentZ "wheel_moment_z" "M_z" "N m" "moment on the wheel about the middle of the axle, upwards"
}

impl Quantity {
    /// The vector of which it is a component, and the name of the component.
    pub fn vector(self) -> Option<(&'static str, &'static str)> {
        let [x, y] = ["x", "y"];
        Some(match self {
            Self::TractionX => ("traction", x),
            Self::TractionY => ("traction", y),
            Self::SlipX => ("slip", x),
            Self::SlipY => ("slip", y),
            Self::DisplacementX => ("displacement", x),
            Self::DisplacementY => ("displacement", y),
            Self::ForceX => ("force", x),
            Self::ForceY => ("force", y),
            Self::MomentZ => ("force", "moment_z"),
            Self::NormalisedX => ("normalised", x),
            Self::NormalisedY => ("normalised", y),
            Self::NormalisedMomentZ => ("normalised", "moment_z"),
            _ => return None,
        })
    }

    /// Where the equation that gives it comes from; empty for inputs, and where it is a definition.
    pub fn source(self) -> &'static str {
        match self {
            Self::TractionX | Self::TractionY => "Neuhaus and Sextro (2014), Eqs. (8), (13)-(16)",
            Self::DisplacementX | Self::DisplacementY => "Neuhaus and Sextro (2014), Eqs. (4)-(7)",
            Self::SlipX | Self::SlipY => "Neuhaus and Sextro (2014), Eqs. (9)-(12)",
            Self::Friction => {
                "Neuhaus and Sextro (2014), Eq. (23), or the friction law in its place"
            }
            Self::FrictionPowerDensity | Self::FrictionPower => {
                "Neuhaus and Sextro (2014), Eqs. (17), (18)"
            }
            Self::RiseWheel
            | Self::RiseRail
            | Self::MaxRise
            | Self::MaxRiseWheel
            | Self::MaxRiseRail => {
                "Neuhaus and Sextro (2014), Eqs. (19)-(22), for a heat source that varies: \
                 Carslaw and Jaeger (1959)"
            }
            Self::StressXx
            | Self::StressYy
            | Self::StressZz
            | Self::StressXy
            | Self::StressXz
            | Self::StressYz => {
                "Love (1929) for the pressure, Ahmadi, Keer and Mura (1983) for the traction"
            }
            Self::FatigueIndex => "Ekberg, Kabo and Andersson (2002)",
            Self::CrackDamage => "Burstow (2004)",
            Self::WearVolume | Self::WearRateArchard => {
                "Archard (1953), with the wear map of Jendel (2002)"
            }
            Self::WearMass | Self::WearRateEnergy => "Braghin, Lewis, Dwyer-Joyce and Bruni (2006)",
            _ => "",
        }
    }

    /// The equation that defines it; empty for what is given or measured, and where a law has its
    /// own. ⟨…⟩ is the mean over a surface.
    pub fn definition(self) -> &'static str {
        match self {
            Self::CreepageX => "ξ = cos α − ω R/v0",
            Self::CreepageY => "η = −sin α",
            Self::Spin => "φ = ω_z/v0",
            Self::Creepage => "ν = √(ξ² + η²)",
            Self::Direction => "tan θ = η/ξ",
            Self::WheelTorque => "T = R F_x",
            Self::BeddingX
            | Self::BeddingY
            | Self::CouplingX
            | Self::CouplingXAcross
            | Self::CouplingY
            | Self::CouplingYAcross => "c u − g_x ∂²u/∂x² − g_y ∂²u/∂y² = t",
            Self::ContactStiffness => "dt/d|δ| = k_c (μ p_n − t)",
            Self::TemperatureAtZeroFriction => "μ = μ0 (1 − T/T_E)",
            Self::LimitRatio | Self::Decay => "μ = μ0 ((1 − A) exp(−B s) + A)",
            Self::FilmCoefficient => "Q̇ = h A (T_w − T_a)",
            Self::RmsHeight | Self::ContactRoughness => "h_rms = √⟨h²⟩",
            Self::RmsSlope => "h'_rms = √⟨|∇h|²⟩",
            Self::SpectralDensity => "h_rms² = ∫ C d²q",
            Self::HurstExponent => "C ∝ q^(−2 − 2H)",
            Self::SlipX => "s_x = v0 (ξ − φ y) + du_x/dt",
            Self::SlipY => "s_y = v0 (η + φ x) + du_y/dt",
            Self::FrictionPowerDensity => "q = −(t_x s_x + t_y s_y)",
            Self::ForceX => "F_x = ∫ t_x dA",
            Self::ForceY => "F_y = ∫ t_y dA",
            Self::MomentZ => "M_z = ∫ (x t_y − y t_x) dA",
            Self::TractionCoefficient => "|F|/N = √(F_x² + F_y²)/N",
            Self::FrictionPower => "P = ∫ q dA",
            Self::CreepPower => "P_c = −v0 (ξ F_x + η F_y + φ M_z)",
            Self::ReturnedPower => "P_r = −∫ min(q, 0) dA",
            Self::WearNumber => "Tγ = |ξ F_x| + |η F_y|, with spin + |φ M_z|",
            Self::FatigueIndex => "FI = |F|/N − k/p0",
            Self::SlipSpeed => "s = P/(μ N)",
            Self::LocalSlipSpeed => "s = √(s_x² + s_y²)",
            Self::VonMisesStress => "σ_v = √(½ [(σ_1 − σ_2)² + (σ_2 − σ_3)² + (σ_3 − σ_1)²])",
            Self::LargestShearStress => "τ_max = (σ_1 − σ_3)/2",
            Self::HydrostaticStress => "σ_m = (σ_xx + σ_yy + σ_zz)/3",
            Self::DissipatedEnergy => "E = ∫ P dt",
            Self::StoredEnergy => "E = ½ ∫ t·u dA",
            Self::Distance => "s = ∫ v0 dt",
            Self::PecletNumber => "v a/κ, κ = λ/(ρ c)",
            Self::RollingRadiusDifference => "Δr = r_left − r_right",
            Self::HarmonicConicity => "tan γ_h = 1/(2π ŷ) ∫ Δr(ŷ sin ψ) sin ψ dψ",
            _ => "",
        }
    }

    /// A value (in its unit, or dimensionless) with six digits and its unit.
    pub fn six_digits(self, value: f64) -> String {
        let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
        let is_usual = rounded == 0.0 || (1e-4..1e6).contains(&rounded.abs());
        let number = if is_usual { rounded.to_string() } else { format!("{rounded:e}") };
        format!("{number} {}", self.unit()).trim_end().to_owned()
    }

    /// The quantity itself, or the longitudinal creepage for a total one.
    pub(crate) fn own_component(self) -> Self {
        if self == Self::Creepage { Self::CreepageX } else { self }
    }

    /// `creepage_x = 0.05`: name and value (in its unit, or dimensionless) with six digits.
    pub fn equation(self, value: f64) -> String {
        format!("{} = {}", self.name(), self.six_digits(value))
    }
}

/// By its name.
#[cfg(feature = "serde")]
impl serde::Serialize for Quantity {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words_and_unique() {
        let mut names: Vec<_> = Quantity::ALL.iter().map(|quantity| quantity.name()).collect();
        let is_word = |name: &&str| name.chars().all(|c| c.is_ascii_lowercase() || c == '_');
        assert!(names.iter().all(is_word));
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Quantity::ALL.len());
    }
}
