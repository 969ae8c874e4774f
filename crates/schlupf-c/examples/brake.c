/* A wheel brakes for ten seconds: linearly implicit steps with the derivative of the force. */
#include <schlupf.h>
#include <stdio.h>

#define INPUTS 8
#define STATES 3
#define COLUMNS (INPUTS + STATES)
#define MOST 10

static const char *const CASE =
    "[kinematics]\n"
    "speed = \"20 m/s\"\n"
    "[friction]\n"
    "model = \"constant\"\n"
    "coefficient = 0.4\n"
    "[solver]\n"
    "method = \"polach\"\n";

int main(void)
{
    const double radius = 0.46, inertia = 70.0, mass = 8000.0, torque = 4000.0, step = 1e-3;
    const char *const set[] = {"normal.load=80 kN"};
    double inputs[INPUTS], states[STATES] = {0.0}, outputs[MOST], slopes[(MOST + STATES) * COLUMNS];
    SchlupfElement wheel;
    char message[500];

    if (schlupf_abi_version() != SCHLUPF_ABI_VERSION) {
        return 1;
    }
    if (schlupf_element_from_text(CASE, NULL, set, 1, &wheel) != SCHLUPF_FOUND) {
        schlupf_element_message(wheel, message, sizeof message);
        fprintf(stderr, "%s\n", message);
        schlupf_element_destroy(wheel);
        return 1;
    }
    const ptrdiff_t v = schlupf_element_find(wheel, SCHLUPF_INPUTS, "velocity_x");
    const ptrdiff_t omega = schlupf_element_find(wheel, SCHLUPF_INPUTS, "angular_velocity");
    const ptrdiff_t force = schlupf_element_find(wheel, SCHLUPF_OUTPUTS, "force_x");
    const size_t rows = schlupf_element_count(wheel, SCHLUPF_OUTPUTS);
    if (v < 0 || omega < 0 || force < 0) {
        return 1;
    }

    SchlupfStatus status = schlupf_element_start(wheel, inputs, INPUTS);
    for (int k = 0; k <= 10000 && status == SCHLUPF_FOUND; k++) {
        status = schlupf_element_evaluate(wheel, inputs, INPUTS, states, STATES, outputs, rows,
                                          NULL, 0, slopes, (rows + STATES) * COLUMNS);
        const double fx = outputs[force], by_omega = slopes[force * COLUMNS + omega];
        if (k % 2000 == 0) {
            printf("%.16e %.16e %.16e\n", inputs[v], inputs[omega], fx);
        }
        inputs[v] += step * fx / mass;
        inputs[omega] += step * (-radius * fx - torque) / (inertia + step * radius * by_omega);
        schlupf_element_advance(wheel, inputs, INPUTS, states, STATES, step);
    }
    if (status != SCHLUPF_FOUND) {
        schlupf_element_message(wheel, message, sizeof message);
        fprintf(stderr, "%s: %s\n", schlupf_status_text(status), message);
    }
    schlupf_element_destroy(wheel);
    return status;
}
