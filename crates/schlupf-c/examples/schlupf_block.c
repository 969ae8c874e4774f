/* The force element as a block of Simulink: mex schlupf_block.c -I… -L… -lschlupf
 *
 * The parameter of the S-function is the path of the case file. The input port has the inputs of
 * the element, the output port its outputs, in the order of schlupf.h; its states are continuous
 * states of the block. */
#define S_FUNCTION_NAME schlupf_block
#define S_FUNCTION_LEVEL 2
#include <schlupf.h>
#include <simstruc.h>

/* Ends the simulation. The text must outlive the call. */
static void report(SimStruct *S, SchlupfElement wheel)
{
    static char message[1000];
    schlupf_element_message(wheel, message, sizeof message);
    ssSetErrorStatus(S, message);
}

/* The element of the case file; 0 where there is none, which is reported. */
static SchlupfElement element_of_case(SimStruct *S)
{
    SchlupfElement wheel = 0;
    char *path = mxArrayToUTF8String(ssGetSFcnParam(S, 0));
    if (schlupf_element_from_file(path, NULL, 0, &wheel) != SCHLUPF_FOUND) {
        report(S, wheel);
        schlupf_element_destroy(wheel);
        wheel = 0;
    }
    mxFree(path);
    return wheel;
}

static void mdlInitializeSizes(SimStruct *S)
{
    SchlupfElement wheel;
    ssSetNumSFcnParams(S, 1);
    if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S)) {
        return; /* Simulink reports it. */
    }
    ssSetSFcnParamTunable(S, 0, SS_PRM_NOT_TUNABLE);
    if ((wheel = element_of_case(S)) == 0) {
        return;
    }
    ssSetNumContStates(S, (int_T)schlupf_element_count(wheel, SCHLUPF_STATES));
    ssSetNumDiscStates(S, 0);
    if (ssSetNumInputPorts(S, 1) && ssSetNumOutputPorts(S, 1)) {
        ssSetInputPortWidth(S, 0, (int_T)schlupf_element_count(wheel, SCHLUPF_INPUTS));
        ssSetInputPortRequiredContiguous(S, 0, 1);
        ssSetInputPortDirectFeedThrough(S, 0, 1);
        ssSetOutputPortWidth(S, 0, (int_T)schlupf_element_count(wheel, SCHLUPF_OUTPUTS));
    }
    ssSetNumSampleTimes(S, 1);
    ssSetNumPWork(S, 1);
    ssSetOptions(S, SS_OPTION_EXCEPTION_FREE_CODE);
    schlupf_element_destroy(wheel);
}

static void mdlInitializeSampleTimes(SimStruct *S)
{
    ssSetSampleTime(S, 0, CONTINUOUS_SAMPLE_TIME);
    ssSetOffsetTime(S, 0, 0.0);
}

#define MDL_START
static void mdlStart(SimStruct *S)
{
    ssSetPWorkValue(S, 0, (void *)(uintptr_t)element_of_case(S));
}

static SchlupfElement held(SimStruct *S)
{
    return (SchlupfElement)(uintptr_t)ssGetPWorkValue(S, 0);
}

/* A contact without tractions. */
#define MDL_INITIALIZE_CONDITIONS
static void mdlInitializeConditions(SimStruct *S)
{
    for (int_T k = 0; k < ssGetNumContStates(S); k++) {
        ssGetContStates(S)[k] = 0.0;
    }
}

static void evaluate(SimStruct *S, real_T *outputs, int_T output_count, real_T *rates,
                     int_T rate_count)
{
    const SchlupfStatus status = schlupf_element_evaluate(
        held(S), ssGetInputPortRealSignal(S, 0), ssGetInputPortWidth(S, 0), ssGetContStates(S),
        ssGetNumContStates(S), outputs, output_count, rates, rate_count, NULL, 0);
    if (status != SCHLUPF_FOUND && status != SCHLUPF_NO_CONTACT
        && status != SCHLUPF_OUTSIDE_TABLE) {
        report(S, held(S));
    }
}

static void mdlOutputs(SimStruct *S, int_T tid)
{
    UNUSED_ARG(tid);
    evaluate(S, ssGetOutputPortRealSignal(S, 0), ssGetOutputPortWidth(S, 0), NULL, 0);
}

#define MDL_DERIVATIVES
static void mdlDerivatives(SimStruct *S)
{
    evaluate(S, NULL, 0, ssGetdX(S), ssGetNumContStates(S));
}

static void mdlTerminate(SimStruct *S)
{
    schlupf_element_destroy(held(S));
}

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
