/* Does with examples/schlupf_block.c what Simulink does; the argument is where to write the case.
 *
 * A wheel slides at 1 %: its states, by Runge–Kutta steps with mdlDerivatives, are those of short
 * steps of schlupf_element_advance, and outputs those of schlupf_element_evaluate, bit for bit. */
#include <math.h>
#include <schlupf.h>
#include <simstruc.h>
#include <stdio.h>

#define INPUTS 8
#define MOST_OUTPUTS 20
#define STATES 3
#define STEPS 500
#define CHECK(condition)                                                      \
    do {                                                                      \
        if (!(condition)) {                                                   \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);   \
            failures++;                                                       \
        }                                                                     \
    } while (0)

static int failures = 0;

static const char *const CASE =
    "kinematics.speed = \"20 m/s\"\n"
    "friction = { model = \"constant\", coefficient = 0.3 }\n"
    "normal.load = \"80 kN\"\n"
    "solver.method = \"shen-hedrick-elkins\"\n";

static void step(SimStruct *S, double duration)
{
    static const double part[] = {0.0, 0.5, 0.5, 1.0}, weight[] = {1.0, 2.0, 2.0, 1.0};
    double start[STATES], rates[STATES] = {0.0}, sum[STATES] = {0.0};
    memcpy(start, S->state, sizeof start);
    for (int stage = 0; stage < 4; stage++) {
        for (int k = 0; k < STATES; k++) {
            S->state[k] = start[k] + part[stage] * duration * rates[k];
        }
        METHODS.derivatives(S);
        memcpy(rates, S->rate, sizeof rates);
        for (int k = 0; k < STATES; k++) {
            sum[k] += weight[stage] * rates[k];
        }
    }
    for (int k = 0; k < STATES; k++) {
        S->state[k] = start[k] + duration / 6.0 * sum[k];
    }
}

static void wrong(const char *path, int count, const char *error)
{
    const mxArray parameter = {path};
    SimStruct S = {.parameters = &parameter, .parameter_count = count};
    METHODS.sizes(&S);
    CHECK(S.input_ports == 0 && S.output_ports == 0);
    CHECK(error == NULL ? S.error == NULL : S.error != NULL && strstr(S.error, error) != NULL);
}

static void slide(SimStruct *S, SchlupfElement wheel)
{
    double states[STATES] = {0.0}, outputs[MOST_OUTPUTS], inputs[INPUTS];
    METHODS.conditions(S);
    CHECK(schlupf_element_start(wheel, inputs, INPUTS) == SCHLUPF_FOUND);
    inputs[3] *= 1.01;
    S->input = inputs;
    for (int k = 0; k < STEPS; k++) {
        step(S, 1e-3 / STEPS);
        schlupf_element_advance(wheel, inputs, INPUTS, states, STATES, 1e-3 / STEPS);
    }
    CHECK(fabs(S->state[0] - states[0]) < 1e-6 * fabs(states[0]));
    METHODS.outputs(S, 0);
    CHECK(S->error == NULL);
    schlupf_element_evaluate(wheel, inputs, INPUTS, S->state, STATES, outputs, S->outputs, NULL, 0,
                             NULL, 0);
    CHECK(memcmp(outputs, S->output, S->outputs * sizeof *outputs) == 0);
    CHECK(fabs(outputs[0]) > 0.5 * 0.3 * 80e3);
    inputs[4] = 0.0;
    METHODS.outputs(S, 0);
    CHECK(S->error == NULL && S->output[0] == 0.0);
    inputs[0] = NAN;
    METHODS.outputs(S, 0);
    CHECK(S->error != NULL && strcmp(S->error, "velocity_x must be finite, but is NaN") == 0);
}

int main(int count, char **arguments)
{
    const mxArray parameter = {count > 1 ? arguments[1] : "case.toml"};
    FILE *file = fopen(parameter.text, "w");
    if (file == NULL || fputs(CASE, file) < 0 || fclose(file) != 0) {
        return 1;
    }
    wrong("nowhere.toml", 1, "nowhere.toml: the case file cannot be read");
    wrong(NULL, 1, "path must not be null");
    wrong(parameter.text, 0, NULL);

    double rates[STATES], states[STATES] = {1.0, 1.0, 1.0}, outputs[MOST_OUTPUTS];
    SimStruct S = {.parameters = &parameter, .parameter_count = 1};
    METHODS.sizes(&S);
    METHODS.sample_times(&S);
    CHECK(S.error == NULL && S.states == STATES && S.inputs == INPUTS);
    CHECK(S.outputs > 0 && S.outputs <= MOST_OUTPUTS);
    CHECK(S.contiguous && S.feedthrough && S.sample_times == 1 && S.pointers == 1);
    CHECK(S.sample_time == CONTINUOUS_SAMPLE_TIME && S.offset_time == 0.0);
    S.state = states;
    S.rate = rates;
    S.output = outputs;
    METHODS.start(&S);
    SchlupfElement wheel;
    CHECK(schlupf_element_from_text(CASE, NULL, NULL, 0, &wheel) == SCHLUPF_FOUND);
    slide(&S, wheel);
    METHODS.terminate(&S);
    CHECK(schlupf_element_destroy((SchlupfElement)(uintptr_t)S.pointer) == SCHLUPF_INVALID_ELEMENT);
    CHECK(schlupf_element_destroy(wheel) == SCHLUPF_FOUND);
    return failures > 0;
}
