// A wheel brakes for ten seconds: linearly implicit steps with the derivative of the force.
#include <cstdio>
#include <schlupf.hpp>

int main() {
    const double radius = 0.46, inertia = 70.0, mass = 8000.0, torque = 4000.0, step = 1e-3;
    try {
        auto wheel = schlupf::Element::from_text(
            "kinematics.speed = \"20 m/s\"\n"
            "friction = { model = \"constant\", coefficient = 0.4 }",
            {"normal.load=80 kN", "solver.method=polach"});
        const auto v = wheel.index(SCHLUPF_INPUTS, "velocity_x");
        const auto omega = wheel.index(SCHLUPF_INPUTS, "angular_velocity");
        const auto force = wheel.index(SCHLUPF_OUTPUTS, "force_x");
        auto inputs = wheel.start();
        std::vector<double> states(wheel.count(SCHLUPF_STATES));
        auto found = wheel.evaluation();
        for (int k = 0; k <= 10000; ++k) {
            if (wheel.evaluate(inputs, states, found) != SCHLUPF_FOUND) {
                std::fprintf(stderr, "%s\n", wheel.message().c_str());
                return 1;
            }
            const double fx = found.outputs[force], by_omega = found.derivative(force, omega);
            if (k % 2000 == 0) std::printf("%.16e %.16e %.16e\n", inputs[v], inputs[omega], fx);
            inputs[v] += step * fx / mass;
            inputs[omega] += step * (-radius * fx - torque) / (inertia + step * radius * by_omega);
            wheel.advance(inputs, states, step);
        }
    } catch (const schlupf::Error &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
