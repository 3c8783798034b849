/* honeycomb.h: honeycomb subdivision of deforming meshes, for C99 and whoever speaks it. Needs libhoneycomb and
 * honeycomb_base.h beside it (version, errors, contexts) alone. docs/c_api.md is the page about it.
 *     once a mesh   hc_tables_create() from polygons and the text of a scheme; counts and index buffers
 *     every frame   hc_evaluate() on the CPU, or hc_vulkan_record() into a command buffer of yours
 *
 * Every function that can fail returns an hc_status, leaves its outputs alone when it fails and never throws, prints or
 * exits. Elements and levels are numbered from 0; indices are 32-bit; coordinates are float.
 *
 * Structs that may grow begin with struct_size: set it to sizeof(the struct), and what you don't name to 0, which is
 * every option's default. A library that is newer than the program reads what the program knows; an older one refuses
 * members that it doesn't know unless they are 0. Pointers to options may be NULL: all defaults.
 *
 * Threads: each function says what it may run beside. `const` objects are only read: any number of threads may use them
 * at once. Nobody may use an object that is being destroyed. Objects keep alive what they were made from, so that they
 * are destroyed in any order; destroying NULL does nothing. */
#ifndef HONEYCOMB_H
#define HONEYCOMB_H
#include "honeycomb_base.h"
#ifdef __cplusplus
extern "C" {
#endif

/* ---- Meshes ---- */

/* An edge that stays sharp for that many steps, from 10 on for all of them, as in OpenSubdiv. */
typedef struct hc_crease {
  int32_t vertex0, vertex1;
  double sharpness; /* >= 0 */
} hc_crease;

/* An oriented manifold of polygons: each face the loop of its vertices, counter-clockwise seen from outside. */
typedef struct hc_polygons {
  size_t struct_size;
  int32_t vertex_count;
  int64_t face_count;
  const int32_t* face_sizes;    /* face_count numbers of sides, from 3 */
  const int64_t* face_offsets;  /* or face_count + 1 places in face_vertices, from 0; exactly one of the two */
  const int32_t* face_vertices; /* face after face */
  int64_t face_vertex_count;    /* numbers in face_vertices: the sum of all sides */
  const hc_crease* creases;     /* crease_count; NULL if 0 */
  int64_t crease_count;
  const int32_t* corners; /* boundary vertices that the brick boundary keeps in place; NULL if there are none */
  int64_t corner_count;
} hc_polygons;

/* Polygons and positions that a file has. Never changes. */
typedef struct hc_mesh hc_mesh;
/* Reads a mesh: OBJ with creases, PLY, and where the library has Assimp the first pose of glTF, FBX, COLLADA ..; `path`
 * is UTF-8. Errors: UNREADABLE, INVALID_FILE, INVALID_POSITIONS, TOO_LARGE, INVALID_ARGUMENT for a format there isn't.
 * Any thread. */
HC_API hc_status hc_mesh_read(hc_context* context, const char* path, hc_mesh** mesh);
HC_API void hc_mesh_destroy(hc_mesh* mesh);
/* Its polygons, whose pointers lead into the mesh. polygons->struct_size is set by the caller. Any thread. */
HC_API hc_status hc_mesh_polygons(const hc_mesh* mesh, hc_polygons* polygons);
/* x y z a vertex, in the mesh's own memory; `count` (may be NULL): how many numbers. Any thread. */
HC_API hc_status hc_mesh_positions(const hc_mesh* mesh, const float** positions, size_t* count);

/* ---- Tables ---- */

/* An option of a scheme by its name on the command line, without the dashes: {"tension", "sqrt3"}, {"boundary",
 * "eq16"}. README lists them. "ccv" and "ccv-offset" are none here: see central_points. */
typedef struct hc_option {
  const char* name;
  const char* value; /* a flag's is not looked at and may be NULL */
} hc_option;

/* Unit normals of the last level's vertices. */
typedef int32_t hc_normals;
enum {
  HC_NORMALS_NONE = 0,
  HC_NORMALS_FAST = 1, /* of a few limit normals of faces round the vertex: for playback */
  HC_NORMALS_EXACT = 2 /* of the limit surface: slower */
};
/* How the faces of level 0 are numbered. */
typedef int32_t hc_order;
enum {
  HC_ORDER_INPUT = 0,
  HC_ORDER_SPATIAL = 1 /* faces that are near each other have near numbers: faster where the caller's order is random */
};

/* The surface that is wanted, and what is to be known of it. */
typedef struct hc_tables_options {
  size_t struct_size;
  const char* scheme;       /* "akleman", "half-box", .., or a chain "catmull-clark:1,akleman:3"; NULL: akleman */
  int32_t levels;           /* of a scheme, 1 .. 20; 0: 2. Of a chain 0 or their sum */
  const hc_option* options; /* option_count; NULL if 0 */
  size_t option_count;
  hc_normals normals;     /* which evaluators will be asked for, at the last level */
  int32_t tiles;          /* not 0: also build tiles, with which a frame takes a fraction of the time; 15 to 150 ns a
                           * vertex to build, 3 bytes a vertex */
  int32_t limits;         /* not 0: also build limit positions and normals of the last level (hc_evaluate_limits) */
  int32_t central_points; /* not 0: control points are [vertices | a central control vertex a face], for schemes that
                           * have them (zhang-wang); 0: these take the barycentres */
  hc_order order;
  int64_t memory_limit; /* bytes the tables may take; 0: no limit */
} hc_tables_options;

/* All that a mesh's connectivity decides, built once. Never changes. */
typedef struct hc_tables hc_tables;
/* Builds the tables of all levels. Linear in the vertices of the last level. Errors: INVALID_MESH (hc_last_element() is
 * the face or vertex), INVALID_ARGUMENT, TOO_LARGE, UNSUPPORTED, OUT_OF_MEMORY. Any thread. */
HC_API hc_status hc_tables_create(hc_context* context, const hc_polygons* polygons, const hc_tables_options* options,
                                  hc_tables** tables);
HC_API void hc_tables_destroy(hc_tables* tables);

/* How far a table file is trusted. */
typedef struct hc_open_options {
  size_t struct_size;
  int32_t trusted; /* not 0: indices are not proven; a broken file then does anything */
} hc_open_options;
/* Maps a table file (.hct) and uses it in place; linear in its size unless trusted. It has the last level's mesh alone,
 * no vertex origins, and fast normals as its tiles do. Errors: UNREADABLE, INVALID_FILE. Any thread. */
HC_API hc_status hc_tables_open(hc_context* context, const char* path, const hc_open_options* options,
                                hc_tables** tables);
/* Writes what hc_tables_create() made to a table file, whole or not at all. Errors: UNWRITABLE; INVALID_ARGUMENT for
 * tables of a file. Any thread. */
HC_API hc_status hc_tables_save(const hc_tables* tables, const char* path);

/* What tables hold. */
typedef struct hc_tables_info {
  size_t struct_size;
  int32_t level_count;    /* the last level; more than asked for where half-box converts a mesh in a step of its own */
  int32_t limits;         /* 1: hc_evaluate_limits() works */
  hc_normals normals;     /* that evaluators find */
  int32_t tiles;          /* 1: there are tiles */
  int64_t control_points; /* points of level 0 */
  int64_t bytes;          /* of all arrays */
} hc_tables_info;
/* info->struct_size is set by the caller. Any thread. */
HC_API hc_status hc_tables_get_info(const hc_tables* tables, hc_tables_info* info);

/* How large a level is. */
typedef struct hc_level_counts {
  size_t struct_size;
  int64_t points; /* that evaluation reads (level 0) or writes: vertices, and behind them central control vertices */
  int64_t vertices, edges, faces;
  int64_t corners; /* of all faces: their sides added up */
  int64_t boundary_edges;
  int64_t triangle_indices; /* what hc_tables_triangles() writes */
  int64_t line_indices;     /* what hc_tables_lines() writes */
} hc_level_counts;
/* Of level 0 .. level_count. counts->struct_size is set by the caller. Any thread. */
HC_API hc_status hc_tables_get_counts(const hc_tables* tables, int32_t level, hc_level_counts* counts);

/* The faces of a level, in the tables' own memory: face f is vertices[offsets[f]] .. vertices[offsets[f + 1] - 1];
 * `faces` + 1 offsets. At level 0 faces are sorted by their number of sides: hc_tables_face_origins() leads to the
 * caller's. Either output may be NULL. Any thread. */
HC_API hc_status hc_tables_faces(const hc_tables* tables, int32_t level, const int32_t** offsets,
                                 const int32_t** vertices);
/* Writes the faces cut into triangles, fans from their first corners, three indices each. `capacity`: numbers that
 * `indices` holds, at least triangle_indices. Any thread. */
HC_API hc_status hc_tables_triangles(const hc_tables* tables, int32_t level, int32_t* indices, int64_t capacity);
/* Writes the edges, each once, two indices each; capacity: at least line_indices. Any thread. */
HC_API hc_status hc_tables_lines(const hc_tables* tables, int32_t level, int32_t* indices, int64_t capacity);

/* The control face or control vertex, in the caller's numbers, that a refined face or vertex descends from, and the
 * level it first appeared at: for materials, selections, picking. */
typedef struct hc_origin {
  int32_t number;
  int32_t level;   /* -1: of tables of a file */
  hc_element kind; /* HC_ELEMENT_FACE or HC_ELEMENT_VERTEX */
} hc_origin;
/* Of each face of a level; capacity: at least `faces` of them. Any thread. */
HC_API hc_status hc_tables_face_origins(const hc_tables* tables, int32_t level, hc_origin* origins, int64_t capacity);
/* Of each vertex of a level; capacity: at least `vertices` of them. Any thread. */
HC_API hc_status hc_tables_vertex_origins(const hc_tables* tables, int32_t level, hc_origin* origins, int64_t capacity);

/* ---- Evaluation on the CPU ---- */

/* Where the values of points lie in a buffer of `size` floats; positions have length 3, texture coordinates 2, anything
 * from 1:
 *     | offset |  length  |  ...        |  length  |  ...
 *              |<--------- stride ----->|<--------- stride -----
 *     point:   0                        1
 * `stride` >= `length`, `offset` >= 0; nothing is needed or touched but the values. */
typedef struct hc_points {
  const float* data;
  size_t size;
  int32_t offset, length, stride;
} hc_points;
/* The same where values are written. */
typedef struct hc_points_out {
  float* data;
  size_t size;
  int32_t offset, length, stride;
} hc_points_out;

/* All give the same bits. */
typedef int32_t hc_backend;
enum {
  HC_BACKEND_AUTO = 0,       /* tbb-tiled where the tables have tiles, else tbb */
  HC_BACKEND_SERIAL = 1,     /* plain loops, level after level: the reference */
  HC_BACKEND_SIMD = 2,       /* the CPU's vectors, one thread */
  HC_BACKEND_TBB = 3,        /* vectors on all threads of the calling thread's oneTBB arena */
  HC_BACKEND_SIMD_TILED = 4, /* tile after tile, one thread; needs tables with tiles */
  HC_BACKEND_TBB_TILED = 5   /* tiles on all threads; needs tables with tiles */
};

/* What evaluates, and whether it looks at its input. */
typedef struct hc_evaluator_options {
  size_t struct_size;
  hc_backend backend;
  int32_t unchecked; /* not 0: points are not looked through for NaN and infinity first, which takes about as long as
                      * reading them */
} hc_evaluator_options;

/* Working memory of evaluations, kept from frame to frame: once warm nothing is allocated. */
typedef struct hc_evaluator hc_evaluator;
/* Any thread. */
HC_API hc_status hc_evaluator_create(hc_context* context, const hc_evaluator_options* options,
                                     hc_evaluator** evaluator);
HC_API void hc_evaluator_destroy(hc_evaluator* evaluator);

/* From the control points to those of level 1 .. level_count, of the same length. `normals` (may be NULL): unit
 * normals, length 3, a zero vector where there is no direction, of the last level's points; needs control points of
 * length 3, or 4 whose first three are positions, and tables with normals. Refined points and normals may be
 * interleaved in one buffer, but not overlap each other or the control points. Errors: INVALID_ARGUMENT,
 * INVALID_POSITIONS (hc_last_element() is the point), OUT_OF_MEMORY: what is written is then undefined where that came
 * late. One thread at a time may use an evaluator; tables are shared. */
HC_API hc_status hc_evaluate(hc_evaluator* evaluator, const hc_tables* tables, int32_t level, const hc_points* control,
                             const hc_points_out* refined, const hc_points_out* normals);

/* Limit positions and unit normals (either may be NULL) of the vertices or faces of the last level (`kind`:
 * HC_ELEMENT_VERTEX or HC_ELEMENT_FACE), from its points; all of length 3. Needs tables with limits or exact normals.
 * Errors and threads: as hc_evaluate(). */
HC_API hc_status hc_evaluate_limits(hc_evaluator* evaluator, const hc_tables* tables, hc_element kind,
                                    const hc_points* points, const hc_points_out* positions,
                                    const hc_points_out* normals);

/* ---- Evaluation on a Vulkan device ---- */

/* Vulkan's own types, declared as vulkan.h does, so that its handles are given as they are. */
struct VkInstance_T;
struct VkPhysicalDevice_T;
struct VkDevice_T;
struct VkQueue_T;
struct VkCommandBuffer_T;
struct VkAllocationCallbacks;
#if defined(__LP64__) || defined(_WIN64) || (defined(__x86_64__) && !defined(__ILP32__)) || defined(__aarch64__)
typedef struct VkBuffer_T* hc_vk_buffer; /* a VkBuffer */
#else
typedef uint64_t hc_vk_buffer; /* a VkBuffer */
#endif
/* A PFN_vkVoidFunction. */
typedef void (*hc_vk_function)(void);
/* A device of the caller's, of Vulkan 1.2 or later, without any feature switched on. All of it outlives what is made
 * from it. */
typedef struct hc_vulkan_device {
  size_t struct_size;
  struct VkInstance_T* instance;
  struct VkPhysicalDevice_T* physical_device;
  struct VkDevice_T* device;
  struct VkQueue_T* queue; /* with compute */
  uint32_t queue_family;
  const struct VkAllocationCallbacks* allocator; /* host memory of Vulkan objects; NULL: the driver's */
  /* vkGetInstanceProcAddr and vkGetDeviceProcAddr; NULL: those of the machine's loader, opened when needed. */
  hc_vk_function (*get_instance_proc_addr)(struct VkInstance_T*, const char*);
  hc_vk_function (*get_device_proc_addr)(struct VkDevice_T*, const char*);
  const char* pipeline_cache; /* a file that keeps compiled pipelines, UTF-8; NULL: none */
  uint64_t max_device_bytes;  /* of memory all tables and bindings may hold; 0: all there is */
  /* Called around everything that is submitted to the queue, with queue_owner, so that an engine that takes the same
   * lock may go on using the queue; both or NULL: nobody else may use it meanwhile. */
  void (*lock_queue)(void*);
  void (*unlock_queue)(void*);
  void* queue_owner;
} hc_vulkan_device;

/* An evaluator on a device. */
typedef struct hc_vulkan hc_vulkan;
/* Errors: NO_DEVICE, UNSUPPORTED (also of a library without Vulkan), INVALID_ARGUMENT, OUT_OF_MEMORY. Any thread. */
HC_API hc_status hc_vulkan_create(hc_context* context, const hc_vulkan_device* device, hc_vulkan** vulkan);
HC_API void hc_vulkan_destroy(hc_vulkan* vulkan);

/* hc_points without the buffer; of length 0 x y z packed (of normals: none). */
typedef struct hc_layout {
  int32_t offset, length, stride;
} hc_layout;

/* What a table on the device evaluates, and where its buffers have their values. */
typedef struct hc_vulkan_table_options {
  size_t struct_size;
  int32_t level; /* 0: the last */
  int32_t tiled; /* not 0: one dispatch for all levels, a workgroup a tile; tiles are built for the device */
  hc_layout control, refined;
  hc_layout normals; /* of the tables' kind, at the last level; as hc_evaluate() has them, but exact ones without tiles
                      * are written for vertices alone */
} hc_vulkan_table_options;

/* Tables on the device. Never changes. */
typedef struct hc_vulkan_table hc_vulkan_table;
/* Uploads. Where host and device share no memory, copies are submitted to the queue and waited for: nobody else may use
 * it meanwhile unless there is a lock_queue. Errors: INVALID_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY, DEVICE_LOST. Any
 * thread, one at a time a device. */
HC_API hc_status hc_vulkan_table_create(hc_vulkan* vulkan, const hc_tables* tables,
                                        const hc_vulkan_table_options* options, hc_vulkan_table** table);
HC_API void hc_vulkan_table_destroy(hc_vulkan_table* table);

/* How much memory a table takes and wants. */
typedef struct hc_vulkan_sizes {
  size_t struct_size;
  uint64_t control, refined, normals; /* bytes that the caller's buffers need; 0: not touched */
  uint64_t table;                     /* bytes of device memory that the tables take */
} hc_vulkan_sizes;
/* sizes->struct_size is set by the caller. Any thread. */
HC_API hc_status hc_vulkan_table_get_sizes(const hc_vulkan_table* table, hc_vulkan_sizes* sizes);

/* Part of a storage buffer of the caller's, from a multiple of minStorageBufferOffsetAlignment. */
typedef struct hc_vulkan_range {
  hc_vk_buffer buffer;
  uint64_t offset, size; /* bytes */
} hc_vulkan_range;
/* The buffers of a frame. */
typedef struct hc_vulkan_targets {
  size_t struct_size;
  hc_vulkan_range control, refined, normals; /* apart from each other; those of size 0 in hc_vulkan_sizes: zeros */
} hc_vulkan_targets;

/* Descriptor sets and scratch memory for a table on some buffers; one for each frame in flight. Lives until what was
 * recorded with it has run. */
typedef struct hc_vulkan_binding hc_vulkan_binding;
/* Any thread. */
HC_API hc_status hc_vulkan_binding_create(const hc_vulkan_table* table, const hc_vulkan_targets* targets,
                                          hc_vulkan_binding** binding);
HC_API void hc_vulkan_binding_destroy(hc_vulkan_binding* binding);

/* Records the dispatches; never submits, waits or allocates. The command buffer is in the recording state outside a
 * render pass and loses its compute pipeline, descriptor set 0 and push constants. Waits for COMPUTE_SHADER /
 * SHADER_WRITE before it on the queue; the caller makes copied control points visible to COMPUTE_SHADER / SHADER_READ
 * (what the host wrote before the submission is), and what is written, by COMPUTE_SHADER / SHADER_WRITE, to its
 * readers: no barrier is left behind. Any thread, as vkCmdDispatch(). */
HC_API hc_status hc_vulkan_record(const hc_vulkan_binding* binding, struct VkCommandBuffer_T* commands);

#ifdef __cplusplus
}
#endif
#endif
