/* schlupf: the force element. Made by cbindgen: do not edit. */

#ifndef SCHLUPF_H
#define SCHLUPF_H

#include <stddef.h>
#include <stdint.h>

/**
 * What became of a call. Codes never change; there may be more of them.
 */
enum {
  /** forces were found, or what was asked for was done */
  SCHLUPF_FOUND = 0,
  /** the wheel does not touch the rail: there are no forces */
  SCHLUPF_NO_CONTACT = 1,
  /** an input or state is not finite; nor are the outputs */
  SCHLUPF_NOT_FINITE = 2,
  /** a solver did not find the state; the outputs are not finite */
  SCHLUPF_NOT_CONVERGED = 3,
  /** an array has another size than it should have; nothing was done */
  SCHLUPF_WRONG_SIZE = 4,
  /** a pointer is null or not aligned; nothing was done */
  SCHLUPF_INVALID_POINTER = 5,
  /** there is no such element; nothing was done */
  SCHLUPF_INVALID_ELEMENT = 6,
  /** another thread uses the element; nothing was done */
  SCHLUPF_BUSY = 7,
  /** the case is wrong: the element has no contact, only a message */
  SCHLUPF_INVALID_CASE = 8,
  /** a file cannot be read: the element has no contact, only a message */
  SCHLUPF_UNREADABLE = 9,
  /** there is no room for another element */
  SCHLUPF_TOO_MANY = 10,
  /** an error of the library, which should be reported */
  SCHLUPF_PANICKED = 11,
  /** forces were found, with contacts beyond the table of the wheel */
  SCHLUPF_OUTSIDE_TABLE = 12,
};

/**
 * Version of the binary interface: grows when a program must be compiled anew.
 */
#define SCHLUPF_ABI_VERSION 1

/**
 * The inputs of an element.
 */
#define SCHLUPF_INPUTS 0

/**
 * The outputs of an element.
 */
#define SCHLUPF_OUTPUTS 1

/**
 * The states of an element.
 */
#define SCHLUPF_STATES 2

/**
 * What became of a call: `SCHLUPF_FOUND` or another code.
 */
typedef int32_t SchlupfStatus;

/**
 * A force element: a number that no other element of the process has; 0 is none.
 *
 * Threads may use different elements at the same time. An element that was destroyed is refused
 * (`SCHLUPF_INVALID_ELEMENT`), one that another thread is using too (`SCHLUPF_BUSY`).
 */
typedef uint64_t SchlupfElement;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Version of the binary interface that the library has: to be `SCHLUPF_ABI_VERSION`.
 */
uint32_t schlupf_abi_version(void);

/**
 * Version of the library, as text.
 */
const char *schlupf_version(void);

/**
 * What a code means.
 */
const char *schlupf_status_text(SchlupfStatus status);

/**
 * Makes an element of the text of a case.
 *
 * `folder` is where relative paths of files in the case start; null for the working directory.
 * `overrides` are texts `section.field=value` in place of what the case says, `--set` of the
 * command.
 *
 * What is wrong with the case is the message of the element, which is made, and to be destroyed,
 * in any case but that of `SCHLUPF_INVALID_POINTER`.
 *
 * Pointers are null or point to what the parameters say.
 */
SchlupfStatus schlupf_element_from_text(const char *text,
                                        const char *folder,
                                        const char *const *overrides,
                                        size_t override_count,
                                        SchlupfElement *element);

/**
 * Makes an element of a case file; relative paths in it start in its folder. Otherwise like
 * `schlupf_element_from_text`.
 *
 * Pointers are null or point to what the parameters say.
 */
SchlupfStatus schlupf_element_from_file(const char *path,
                                        const char *const *overrides,
                                        size_t override_count,
                                        SchlupfElement *element);

/**
 * Makes an independent copy of an element; a solver begins anew.
 *
 * `copy` is null or points to an element.
 */
SchlupfStatus schlupf_element_clone(SchlupfElement element, SchlupfElement *copy);

/**
 * Destroys an element.
 */
SchlupfStatus schlupf_element_destroy(SchlupfElement element);

/**
 * Number of its inputs, outputs or states (`SCHLUPF_INPUTS`, …); 0 where there is no such element.
 */
size_t schlupf_element_count(SchlupfElement element,
                             int32_t kind);

/**
 * Name of an input, output or state; null where there is none. The pointer stays valid, also
 * after the element was destroyed.
 */
const char *schlupf_element_name(SchlupfElement element, int32_t kind, size_t index);

/**
 * Its unit; empty where it is dimensionless. Otherwise like `schlupf_element_name`.
 */
const char *schlupf_element_unit(SchlupfElement element, int32_t kind, size_t index);

/**
 * What it is. Otherwise like `schlupf_element_name`.
 */
const char *schlupf_element_description(SchlupfElement element, int32_t kind, size_t index);

/**
 * Index of the input, output or state of a name; −1 where there is none.
 *
 * `name` is null or a text.
 */
ptrdiff_t schlupf_element_find(SchlupfElement element, int32_t kind, const char *name);

/**
 * The inputs that the case describes. States start at zero, which is a contact without tractions.
 *
 * `inputs` is null or has room for so many numbers.
 */
SchlupfStatus schlupf_element_start(SchlupfElement element, double *inputs, size_t input_count);

/**
 * Finds outputs, rates of the states (in their unit over s) and derivatives.
 *
 * Derivatives are those of the outputs and, after them, of the rates, a row each, with respect to
 * the inputs and, after them, the states: (outputs + states) × (inputs + states) numbers, row by
 * row. Outputs, rates and derivatives that are not wanted have the size 0. Fast methods without
 * fields allocate no memory.
 *
 * Arrays are null or have so many numbers.
 */
SchlupfStatus schlupf_element_evaluate(SchlupfElement element,
                                       const double *inputs,
                                       size_t input_count,
                                       const double *states,
                                       size_t state_count,
                                       double *outputs,
                                       size_t output_count,
                                       double *rates,
                                       size_t rate_count,
                                       double *derivatives,
                                       size_t derivative_count);

/**
 * The same for many wheels or instants, a row of each array for each, on the thread of the caller.
 * Sizes are those of whole arrays. `statuses` gets the code of each row, or is null. Returns the
 * largest of them.
 *
 * Arrays are null or have so many numbers, `statuses` is null or has room for `row_count` codes.
 */
SchlupfStatus schlupf_element_evaluate_rows(SchlupfElement element,
                                            size_t row_count,
                                            const double *inputs,
                                            size_t input_count,
                                            const double *states,
                                            size_t state_count,
                                            double *outputs,
                                            size_t output_count,
                                            double *rates,
                                            size_t rate_count,
                                            double *derivatives,
                                            size_t derivative_count,
                                            SchlupfStatus *statuses);

/**
 * Lets time pass (in s) with constant inputs: `states` become those afterwards. What is not
 * finite, or a negative duration, is `SCHLUPF_NOT_FINITE`, and they stay as they are.
 *
 * Arrays are null or have so many numbers.
 */
SchlupfStatus schlupf_element_advance(SchlupfElement element,
                                      const double *inputs,
                                      size_t input_count,
                                      double *states,
                                      size_t state_count,
                                      double duration);

/**
 * Forgets what a solver found last, from which it would start: for results that do not depend on
 * what was evaluated before, not even within the tolerance.
 */
SchlupfStatus schlupf_element_forget(SchlupfElement element);

/**
 * Copies the message of an element: what is wrong with its case or kept the last call on it from
 * its work, empty where nothing did. Returns the bytes of the whole message, without the null byte
 * at its end; as many as fit into `size` are copied, with a null byte.
 *
 * `message` is null or has room for `size` bytes.
 */
size_t schlupf_element_message(SchlupfElement element, char *message, size_t size);

/**
 * Copies what the method of an element neglects at the load of its case: a line for each warning,
 * which begins with its code; empty where there is none, or no element. Otherwise like
 * `schlupf_element_message`.
 *
 * `warnings` is null or has room for `size` bytes.
 */
size_t schlupf_element_warnings(SchlupfElement element, char *warnings, size_t size);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SCHLUPF_H */
