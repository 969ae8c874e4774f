/* Whatever a program does with the library is a code; valgrind watches. Threads give what one does. */
#include <math.h>
#include <pthread.h>
#include <schlupf.h>
#include <stdio.h>
#include <string.h>

#define THREADS 8
#define STEPS 50
#define OUTPUTS 9
#define CHECK(condition)                                                  \
    do {                                                                  \
        if (!(condition)) {                                               \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            failures++;                                                   \
        }                                                                 \
    } while (0)

static int failures = 0;

static const char *const CASE = "solver.method = \"polach\"\nfriction.model = \"constant\"";

struct run {
    double found[STEPS][OUTPUTS];
    SchlupfStatus status;
};

static void *run(void *place)
{
    struct run *run = place;
    SchlupfElement wheel;
    double inputs[8], states[3] = {0.0, 0.0, 0.0};
    run->status = schlupf_element_from_text(CASE, NULL, NULL, 0, &wheel);
    schlupf_element_start(wheel, inputs, 8);
    for (int k = 0; k < STEPS && run->status == SCHLUPF_FOUND; k++) {
        inputs[0] *= 0.99;
        inputs[4] *= 0.999;
        run->status = schlupf_element_advance(wheel, inputs, 8, states, 3, 1e-3);
        schlupf_element_evaluate(wheel, inputs, 8, states, 3, run->found[k], OUTPUTS, NULL, 0,
                                 NULL, 0);
    }
    schlupf_element_destroy(wheel);
    return NULL;
}

static void threads(void)
{
    static struct run one, runs[THREADS];
    pthread_t all[THREADS];
    run(&one);
    CHECK(one.status == SCHLUPF_FOUND);
    for (int k = 0; k < THREADS; k++) {
        CHECK(pthread_create(&all[k], NULL, run, &runs[k]) == 0);
    }
    for (int k = 0; k < THREADS; k++) {
        pthread_join(all[k], NULL);
        CHECK(memcmp(&runs[k], &one, sizeof one) == 0);
    }
}

int main(void)
{
    SchlupfElement wheel = 0, copy = 0, wrong = 0;
    double inputs[8], states[3] = {0.0, 0.0, 0.0}, outputs[OUTPUTS];
    char message[200];

    CHECK(schlupf_abi_version() == SCHLUPF_ABI_VERSION);
    CHECK(schlupf_element_from_text(NULL, NULL, NULL, 0, &wrong) == SCHLUPF_INVALID_POINTER);
    CHECK(schlupf_element_destroy(wrong) == SCHLUPF_FOUND);
    CHECK(schlupf_element_from_text(CASE, NULL, NULL, 0, NULL) == SCHLUPF_INVALID_POINTER);
    CHECK(schlupf_element_from_text("[", NULL, NULL, 0, &wrong) == SCHLUPF_INVALID_CASE);
    CHECK(schlupf_element_message(wrong, message, sizeof message) > 0);
    CHECK(strstr(message, "not TOML") != NULL);
    CHECK(schlupf_element_start(wrong, inputs, 8) == SCHLUPF_INVALID_CASE);
    CHECK(schlupf_element_destroy(wrong) == SCHLUPF_FOUND);
    CHECK(schlupf_element_from_file("/nowhere", NULL, 0, &wrong) == SCHLUPF_UNREADABLE);
    CHECK(schlupf_element_destroy(wrong) == SCHLUPF_FOUND);

    CHECK(schlupf_element_from_text(CASE, NULL, NULL, 0, &wheel) == SCHLUPF_FOUND);
    CHECK(schlupf_element_count(wheel, SCHLUPF_OUTPUTS) == OUTPUTS);
    CHECK(strcmp(schlupf_element_unit(wheel, SCHLUPF_INPUTS, 4), "N") == 0);
    CHECK(schlupf_element_name(wheel, SCHLUPF_INPUTS, 8) == NULL);
    CHECK(schlupf_element_name(wheel, 7, 0) == NULL);
    CHECK(schlupf_element_start(wheel, inputs, 7) == SCHLUPF_WRONG_SIZE);
    CHECK(schlupf_element_start(wheel, inputs, 8) == SCHLUPF_FOUND);
    CHECK(schlupf_element_evaluate(wheel, NULL, 8, states, 3, outputs, OUTPUTS, NULL, 0, NULL, 0)
          == SCHLUPF_INVALID_POINTER);
    CHECK(schlupf_element_evaluate(wheel, inputs, 8, states, 3, NULL, OUTPUTS, NULL, 0, NULL, 0)
          == SCHLUPF_INVALID_POINTER);
    CHECK(schlupf_element_evaluate(wheel, inputs, 8, states, (size_t)-1, outputs, OUTPUTS, NULL, 0,
                                   NULL, 0) == SCHLUPF_WRONG_SIZE);
    CHECK(schlupf_element_evaluate_rows(wheel, (size_t)-1, inputs, 8, states, 3, outputs, OUTPUTS,
                                        NULL, 0, NULL, 0, NULL) == SCHLUPF_WRONG_SIZE);
    inputs[0] = NAN;
    CHECK(schlupf_element_evaluate(wheel, inputs, 8, states, 3, outputs, OUTPUTS, NULL, 0, NULL, 0)
          == SCHLUPF_NOT_FINITE);
    CHECK(isnan(outputs[0]));
    CHECK(schlupf_element_clone(wheel, &copy) == SCHLUPF_FOUND);
    CHECK(schlupf_element_destroy(wheel) == SCHLUPF_FOUND);
    CHECK(schlupf_element_destroy(wheel) == SCHLUPF_INVALID_ELEMENT);
    CHECK(schlupf_element_start(wheel, inputs, 8) == SCHLUPF_INVALID_ELEMENT);
    CHECK(schlupf_element_start(12345, inputs, 8) == SCHLUPF_INVALID_ELEMENT);
    wrong = copy;
    CHECK(schlupf_element_clone(wheel, &wrong) == SCHLUPF_INVALID_ELEMENT && wrong == 0);
    CHECK(schlupf_element_start(copy, inputs, 8) == SCHLUPF_FOUND);
    inputs[4] = -1.0;
    CHECK(schlupf_element_evaluate(copy, inputs, 8, states, 3, outputs, OUTPUTS, NULL, 0, NULL, 0)
          == SCHLUPF_NO_CONTACT);
    CHECK(outputs[0] == 0.0);
    CHECK(schlupf_element_destroy(copy) == SCHLUPF_FOUND);
    threads();
    return failures > 0;
}
