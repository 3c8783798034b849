// Mesa's software driver and the LLVM it compiles shaders with keep caches and options until the process ends, which the
// leak checker reports as theirs. Only what is allocated inside these libraries is passed over: an object of ours that
// isn't destroyed keeps its memory through our own frames and libvulkan's, and is also seen by validation's tracking.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() { return "leak:libvulkan_lvp.so\nleak:libLLVM-15.so\n"; }
