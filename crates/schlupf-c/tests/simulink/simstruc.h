/* What examples/schlupf_block.c uses of simstruc.h and matrix.h of MATLAB, and no more.
 *
 * It stands for these types, constants and functions (macros there) as their documentation
 * describes them, for a block of at most one port a side, one parameter, one sample time and one
 * pointer. Options, sizes of discrete states and whether a parameter is tunable are not kept.
 * simulink.c beside it, which the S-function includes at its end, exports its methods. */
#ifndef SIMSTRUC_H
#define SIMSTRUC_H

#include <stdlib.h>
#include <string.h>

typedef double real_T;
typedef int int_T;

/* matrix.h: an array that is a text. */
typedef struct {
    const char *text;
} mxArray;

static inline char *mxArrayToUTF8String(const mxArray *array)
{
    char *copy = array->text == NULL ? NULL : malloc(strlen(array->text) + 1);
    return copy == NULL ? NULL : strcpy(copy, array->text);
}

static inline void mxFree(void *pointer) { free(pointer); }

/* simstruc.h */
typedef struct {
    /* Of the block's dialog. */
    const mxArray *parameters;
    int_T parameter_count;
    /* Of mdlInitializeSizes and mdlInitializeSampleTimes. */
    int_T wanted_parameters, states, input_ports, output_ports, inputs, outputs, contiguous,
        feedthrough, sample_times, pointers;
    real_T sample_time, offset_time;
    /* Of the engine. */
    const real_T *input;
    real_T *output, *state, *rate;
    void *pointer;
    const char *error;
} SimStruct;

#define UNUSED_ARG(argument) (void)(argument)
#define CONTINUOUS_SAMPLE_TIME 0.0
#define SS_PRM_NOT_TUNABLE 0
#define SS_OPTION_EXCEPTION_FREE_CODE 1

#define ssSetNumSFcnParams(S, count) ((S)->wanted_parameters = (count))
#define ssGetNumSFcnParams(S) ((S)->wanted_parameters)
#define ssGetSFcnParamsCount(S) ((S)->parameter_count)
#define ssGetSFcnParam(S, index) (&(S)->parameters[index])
#define ssSetSFcnParamTunable(S, index, value) ((void)(S), (void)(index), (void)(value))
#define ssSetNumContStates(S, count) ((S)->states = (count))
#define ssGetNumContStates(S) ((S)->states)
#define ssSetNumDiscStates(S, count) ((void)(S), (void)(count))
#define ssSetNumInputPorts(S, count) ((S)->input_ports = (count), (count) <= 1)
#define ssSetNumOutputPorts(S, count) ((S)->output_ports = (count), (count) <= 1)
#define ssSetInputPortWidth(S, port, width) ((S)->inputs = (width))
#define ssGetInputPortWidth(S, port) ((S)->inputs)
#define ssSetOutputPortWidth(S, port, width) ((S)->outputs = (width))
#define ssGetOutputPortWidth(S, port) ((S)->outputs)
#define ssSetInputPortRequiredContiguous(S, port, value) ((S)->contiguous = (value))
#define ssSetInputPortDirectFeedThrough(S, port, value) ((S)->feedthrough = (value))
#define ssSetNumSampleTimes(S, count) ((S)->sample_times = (count))
#define ssSetSampleTime(S, index, time) ((S)->sample_time = (time))
#define ssSetOffsetTime(S, index, time) ((S)->offset_time = (time))
#define ssSetNumPWork(S, count) ((S)->pointers = (count))
#define ssSetPWorkValue(S, index, value) ((S)->pointer = (value))
#define ssGetPWorkValue(S, index) ((S)->pointer)
#define ssSetOptions(S, options) ((void)(S), (void)(options))
#define ssGetInputPortRealSignal(S, port) ((S)->input)
#define ssGetOutputPortRealSignal(S, port) ((S)->output)
#define ssGetContStates(S) ((S)->state)
#define ssGetdX(S) ((S)->rate)
#define ssSetErrorStatus(S, text) ((S)->error = (text))

/* What simulink.c exports. */
typedef struct {
    void (*sizes)(SimStruct *), (*sample_times)(SimStruct *), (*start)(SimStruct *),
        (*conditions)(SimStruct *), (*outputs)(SimStruct *, int_T), (*derivatives)(SimStruct *),
        (*terminate)(SimStruct *);
} Methods;

extern const Methods METHODS;

#endif
