/* In place of MATLAB's: the methods that the S-function has defined. */
#if !defined(MDL_START) || !defined(MDL_INITIALIZE_CONDITIONS) || !defined(MDL_DERIVATIVES) \
    || S_FUNCTION_LEVEL != 2
#error "a method is not announced"
#endif

const Methods METHODS = {mdlInitializeSizes, mdlInitializeSampleTimes, mdlStart,
                         mdlInitializeConditions, mdlOutputs, mdlDerivatives, mdlTerminate};
