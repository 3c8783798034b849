#ifdef HONEYCOMB_SANITIZED

// Assimp loses some of what it has allocated where a file turns out to be damaged.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libassimp.so\n";
}

#endif
