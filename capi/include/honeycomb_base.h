/* honeycomb_base.h: what all parts of honeycomb.h speak of, which includes it: version, errors, contexts. */
#ifndef HONEYCOMB_BASE_H
#define HONEYCOMB_BASE_H
#include <stddef.h>
#include <stdint.h>
#if defined(_WIN32) && defined(HC_BUILD)
#define HC_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(HC_STATIC)
#define HC_API __declspec(dllimport)
#elif defined(__GNUC__)
#define HC_API __attribute__((visibility("default")))
#else
#define HC_API
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* ---- Version ---- */

#define HC_VERSION_MAJOR 0
#define HC_VERSION_MINOR 1
#define HC_VERSION_PATCH 0
#define HC_MAKE_VERSION(major, minor, patch) (((uint32_t)(major) << 22) | ((uint32_t)(minor) << 12) | (uint32_t)(patch))
#define HC_VERSION HC_MAKE_VERSION(HC_VERSION_MAJOR, HC_VERSION_MINOR, HC_VERSION_PATCH)

/* The version of the library that runs; the header's is HC_VERSION. Before 1.0 another minor version is another library
 * (the soname says so); from then on another major one. Any thread. */
HC_API uint32_t hc_version(void);

/* ---- Errors ---- */

/* What came of a call. */
typedef int32_t hc_status;
enum {
  HC_OK = 0,
  HC_ERROR_INVALID_ARGUMENT = 1,  /* NULL, a count, an index, a buffer or an option out of its range */
  HC_ERROR_INVALID_MESH = 2,      /* the polygons are not an oriented manifold */
  HC_ERROR_INVALID_FILE = 3,      /* a file that can't be understood */
  HC_ERROR_INVALID_POSITIONS = 4, /* NaN or infinity */
  HC_ERROR_TOO_LARGE = 5,         /* past 2^31 - 1 corners, or past the memory allowed */
  HC_ERROR_UNREADABLE = 6,        /* the system refused to open or read */
  HC_ERROR_UNWRITABLE = 7,        /* the system refused to create or write */
  HC_ERROR_NO_DEVICE = 8,         /* no usable Vulkan */
  HC_ERROR_DEVICE_LOST = 9,       /* the Vulkan device stopped answering */
  HC_ERROR_OUT_OF_MEMORY = 10,    /* of the host or the device */
  HC_ERROR_UNSUPPORTED = 11,      /* this library, file or device lacks something that is needed */
  HC_ERROR_INTERNAL = 12          /* a defect of the library */
};

/* "HC_ERROR_INVALID_MESH"; "unknown hc_status" for numbers that are none. Any thread. */
HC_API const char* hc_status_name(hc_status status);

/* What went wrong in the last call on the calling thread that failed: one line of UTF-8, what and what to do, cut at
 * 1023 bytes; "" before the first. Options are called as on the command line, --NAME. Valid until the thread's next
 * failure or end. Any thread: each has its own. */
HC_API const char* hc_last_message(void);
/* What a number is of. */
typedef int32_t hc_element;
enum { HC_ELEMENT_NONE = 0, HC_ELEMENT_VERTEX = 1, HC_ELEMENT_FACE = 2, HC_ELEMENT_OTHER = 3 };

/* The number of the vertex or face of the caller's mesh, or of something else such as a line, that hc_last_message() is
 * about, -1: none; `kind` (may be NULL) says which. Any thread: each has its own. */
HC_API int64_t hc_last_element(hc_element* kind);

/* ---- Context ---- */

/* Where the blocks of the objects that this API hands out come from, those of a context's own. The arrays in them
 * (tables, scratch memory of evaluators) come from the C++ library's operator new, which callbacks can't reach:
 * hc_tables_options.memory_limit bounds them, hc_tables_info tells their size. Host memory of Vulkan objects:
 * hc_vulkan_device.allocator. Called from whichever thread calls the API. */
typedef struct hc_allocator {
  void* user;                                                   /* handed to both */
  void* (*allocate)(void* user, size_t size, size_t alignment); /* NULL: there is none, HC_ERROR_OUT_OF_MEMORY */
  void (*release)(void* user, void* block);                     /* of a block that allocate() gave */
} hc_allocator;

/* What a message is. */
typedef int32_t hc_severity;
enum { HC_LOG_NOTE = 0, HC_LOG_ERROR = 1 };
/* Where memory comes from and messages go. */
typedef struct hc_context_options {
  size_t struct_size;
  hc_allocator allocator; /* both functions or neither: malloc() and free() */
  /* Called with what hc_last_message() says of every failure (HC_LOG_ERROR), and with what is no error but worth
   * knowing (HC_LOG_NOTE): what reading a file left out, steps that a scheme adds. On the thread of the call that it is
   * about, before that returns; must be safe from several threads if the API is called from several, and return. */
  void (*log)(void* log_user, hc_severity severity, const char* message);
  void* log_user;
} hc_context_options;
/* What objects share. Never changes. */
typedef struct hc_context hc_context;
/* Where a context is taken NULL may be given: malloc(), and no log. Any thread. */
HC_API hc_status hc_context_create(const hc_context_options* options, hc_context** context);
HC_API void hc_context_destroy(hc_context* context);

#ifdef __cplusplus
}
#endif
#endif
