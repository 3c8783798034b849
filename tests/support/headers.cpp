// The target that owns the precompiled headers of all tests needs a source of its own.
