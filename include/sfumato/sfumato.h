#ifndef SFUMATO_H
#define SFUMATO_H

/** @file
 * Sfumato's C interface, ABI 1, for other languages. docs/c-api.md has a program.
 *
 * @code{.c}
 * sfumato_context* c = sfumato_context_new("threads=4");
 * sfumato_document* d = NULL;
 * sfumato_picture* p = NULL;
 * if (sfumato_read(c, bytes, size, "in.svg", NULL, &d) || sfumato_solve(c, d, "max-error=1", &p) ||
 *     sfumato_raster(c, p, &image, "background=white"))
 *   puts(sfumato_error_text(c));
 * @endcode
 *
 * **Errors.** A function that can fail returns a ::sfumato_status_code, SFUMATO_OK = 0. After an
 * error the pointer in its last parameter is NULL. The context keeps reason and place until its
 * next call. Nothing is thrown or printed.
 * **Ownership.** Free an object that a function returns as T*, or through a T**, by the `_free` of
 * T, which accepts NULL. The order does not matter: a context may be freed before its objects. No
 * block of memory changes its owner.
 * **Options** are one string, "key=value key key=value", with the keys and values of the command's
 * long options (docs/cli.md). NULL and "" are the defaults. A value with blanks is quoted,
 * title="A fish", with \\" and \\\\ for a quote and a backslash in it. A key or a value that a call
 * does not accept is SFUMATO_BAD_USAGE, and the text names it.
 * **Views** of tables are borrowed: they last until their owner is changed or freed.
 * **Threads.** Use a context for one call at a time; several contexts may work at once. Several
 * calls may read a document, picture or field while none changes it. Only sfumato_cancel() may be
 * called from another thread, or from a signal handler.
 * **Stability.** A library of ABI 1 serves every program that was built against an earlier header
 * of ABI 1. Structs here are final; enumerations only grow at their end. */

#include <stddef.h>
#include <stdint.h>

/** Marks the functions that the library exports. */
#if defined(__GNUC__)
#define SFUMATO_API __attribute__((visibility("default")))
#else
#define SFUMATO_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The ABI of this header. */
#define SFUMATO_ABI 1

/** Returns the version of the library that runs, as "0.1.0". */
SFUMATO_API const char* sfumato_version(void);
/** Returns the ABI of the library that runs. Compare it with SFUMATO_ABI. */
SFUMATO_API uint32_t sfumato_abi(void);

/** @name Errors
 * @{ */

/** The status codes that functions return. */
enum sfumato_status_code {
  SFUMATO_OK = 0,            /**< success */
  SFUMATO_BAD_INPUT = 1,     /**< the input cannot be understood or drawn */
  SFUMATO_LIMIT = 2,         /**< a limit, the memory budget or the deadline was exceeded */
  SFUMATO_CANCELLED = 3,     /**< sfumato_cancel() was called */
  SFUMATO_IO = 4,            /**< the system refused to read or write */
  SFUMATO_OUT_OF_MEMORY = 5, /**< the system could not allocate memory */
  SFUMATO_UNAVAILABLE = 6,   /**< this library or machine lacks the feature */
  SFUMATO_INTERNAL = 7,      /**< an internal error of the library: please report it */
  SFUMATO_BAD_USAGE = 8      /**< invalid argument: NULL, an index, a size or an option */
};

/** @}
 * @name Contexts
 * @{ */

/** Holds threads, bounds on memory and time, and the last error. */
typedef struct sfumato_context sfumato_context;

/** Makes a context. Returns NULL where memory is exhausted. Where an option is wrong,
 * sfumato_error_text() reports it at once, and every call with the context fails.
 *
 * options: threads=N [all cores], max-memory=MIB of work and of the documents, pictures and fields
 * that the context made [2048], max-time=SECONDS of each call [off], limit.NAME=VALUE
 * (docs/limits.md), simd=sse2|avx2|avx512 [the best of the machine]. */
SFUMATO_API sfumato_context* sfumato_context_new(const char* options);
/** Frees a context. */
SFUMATO_API void sfumato_context_free(sfumato_context* context);

/** Returns the text of the last call's error, without its place; "" after success. Never NULL. */
SFUMATO_API const char* sfumato_error_text(const sfumato_context* context);
/** Returns the name of the input that the last error is about, or "". Never NULL. */
SFUMATO_API const char* sfumato_error_file(const sfumato_context* context);
/** Gives line and column (in bytes) of the last error, from 1; 0: unknown. Either may be NULL. */
SFUMATO_API void sfumato_error_place(const sfumato_context* context, int32_t* line,
                                     int32_t* column);
/** Returns a warning of the last read, import or export, with its place; NULL past the last. */
SFUMATO_API const char* sfumato_warning(const sfumato_context* context, size_t index);

/** Receives reports of progress. `stage` is a word, such as "gather"; `fraction` is from 0 to 1.
 * Any thread may call it, also several at once. It may call only sfumato_cancel(). */
typedef void (*sfumato_progress_fn)(void* user, const char* stage, double fraction);
/** Sets the function that receives progress; NULL: none. */
SFUMATO_API void sfumato_set_progress(sfumato_context* context, sfumato_progress_fn progress,
                                      void* user);

/** Ends this and later calls by SFUMATO_CANCELLED, in about 50 ms, until sfumato_resume(). */
SFUMATO_API void sfumato_cancel(sfumato_context* context);
/** Allows calls again after sfumato_cancel(). */
SFUMATO_API void sfumato_resume(sfumato_context* context);

/** @}
 * @name Bytes and views
 * @{ */

/** Bytes that the library owns, such as the content of a file. */
typedef struct sfumato_bytes sfumato_bytes;
/** Returns the first byte; NULL where there are none. */
SFUMATO_API const uint8_t* sfumato_bytes_data(const sfumato_bytes* bytes);
/** Returns the number of bytes. */
SFUMATO_API size_t sfumato_bytes_size(const sfumato_bytes* bytes);
/** Frees bytes. */
SFUMATO_API void sfumato_bytes_free(sfumato_bytes* bytes);

/** Types of the numbers in a table. */
enum sfumato_number_type {
  SFUMATO_U8 = 1,  /**< uint8_t */
  SFUMATO_U32 = 2, /**< uint32_t */
  SFUMATO_F32 = 3, /**< float */
  SFUMATO_F64 = 4  /**< double */
};
/** A table of numbers: borrowed and read-only. */
typedef struct sfumato_view {
  const void* data; /**< row by row; NULL without rows */
  size_t rows;      /**< number of rows */
  size_t row_bytes; /**< bytes from one row to the next */
  uint32_t columns; /**< numbers of a row */
  uint32_t type;    /**< a ::sfumato_number_type */
} sfumato_view;

/** @}
 * @name Documents
 * @{ */

/** Diffusion curves as their author drew them. */
typedef struct sfumato_document sfumato_document;

/** Receives the bytes of a file from a loader; `sink` is the loader's argument of this name. */
typedef void (*sfumato_deliver_fn)(void* sink, const void* bytes, size_t byte_count);

/** Loads the files that a document names: its textures. */
typedef struct sfumato_loader {
  /** Calls deliver(sink, bytes, byte_count) once and returns 0, or returns another number to
   * refuse. `href` is as in the document, percent signs decoded. Refuse paths that lead out of the
   * folder that you allow. */
  int32_t (*load)(void* user, const char* href, sfumato_deliver_fn deliver, void* sink);
  void* user; /**< passed to `load` */
} sfumato_loader;

/** Reads SVG or Orzan's XML, packed by gzip or not. `name` is for messages, or NULL. `loader` may
 * be NULL: a document that names a file is then an error. */
SFUMATO_API int32_t sfumato_read(sfumato_context* context, const void* bytes, size_t byte_count,
                                 const char* name, const sfumato_loader* loader,
                                 sfumato_document** document);
/** Makes a document from an ordinary SVG (docs/import.md), whose shapes sfumato_read() leaves out.
 * The parameters are as in sfumato_read(). Content that is left out causes a warning. */
SFUMATO_API int32_t sfumato_import_svg(sfumato_context* context, const void* bytes,
                                       size_t byte_count, const char* name,
                                       const sfumato_loader* loader, sfumato_document** document);
/** Combines two regions: "unite", "intersect", "subtract" (first without second) or "exclude". They
 * are path data of SVG, filled by the nonzero rule; so is `path`, whose inside is on the right and
 * which is empty if nothing is left. `tolerance`: of crossings, in the paths' units, above 0. */
SFUMATO_API int32_t sfumato_combine_paths(sfumato_context* context, const char* operation,
                                          const char* first, const char* second, double tolerance,
                                          sfumato_bytes** path);
/** Makes a document of one layer without curves, painted once.
 *
 * options: artboard=X,Y,W,H (required), interpolation=srgb|linear|oklab, background=COLOR. */
SFUMATO_API int32_t sfumato_document_new(sfumato_context* context, const char* options,
                                         sfumato_document** document);
/** Copies a document, for example for an undo. */
SFUMATO_API int32_t sfumato_document_copy(sfumato_context* context, const sfumato_document* from,
                                          sfumato_document** document);
/** Frees a document. */
SFUMATO_API void sfumato_document_free(sfumato_document* document);
/** Writes a document as SVG, exactly. */
SFUMATO_API int32_t sfumato_document_write(sfumato_context* context,
                                           const sfumato_document* document, sfumato_bytes** bytes);
/** Finds probable mistakes. `json` receives one line of JSON, as `sfumato lint --json` prints it
 * (docs/cli.md), whose "file" is the name from sfumato_read(). Costs a mesh of every layer.
 *
 * options: verbose, for notes too. */
SFUMATO_API int32_t sfumato_lint(sfumato_context* context, const sfumato_document* document,
                                 const char* options, sfumato_bytes** json);
/** Gives the part of the plane that is shown: x, y, width and height, in user units. */
SFUMATO_API int32_t sfumato_document_artboard(const sfumato_document* document, double box[4]);
/** The spaces for mixing colours. */
enum sfumato_interpolation {
  SFUMATO_SRGB = 0,   /**< sRGB code values, 0 to 1 */
  SFUMATO_LINEAR = 1, /**< linear light, 0 to 1 */
  SFUMATO_OKLAB = 2   /**< OKLab: L, a and b */
};
/** Returns the ::sfumato_interpolation of a document's colours and of SFUMATO_COLOR_VALUES. */
SFUMATO_API int32_t sfumato_document_interpolation(const sfumato_document* document);
/** Returns the number of layers. */
SFUMATO_API uint32_t sfumato_layer_count(const sfumato_document* document);
/** Returns the number of diffusion curves of a layer. */
SFUMATO_API uint32_t sfumato_curve_count(const sfumato_document* document, uint32_t layer);
/** Returns the id of a layer, perhaps ""; NULL where there is no such layer. */
SFUMATO_API const char* sfumato_layer_id(const sfumato_document* document, uint32_t layer);
/** Returns the id of a curve, perhaps ""; NULL where there is no such curve. */
SFUMATO_API const char* sfumato_curve_id(const sfumato_document* document, uint32_t layer,
                                         uint32_t curve);
/** Finds the place of a curve in the text that sfumato_read() read. `byte_offset` counts the bytes
 * before the `<` of its element, a shape, also where a `use` copies it. `subpath` counts the
 * element's subpaths from 0, without movements that draw nothing. Both are 0 where unknown: for
 * inserted curves, Orzan's XML, and text that is packed or not UTF-8. Either may be NULL. Edits of
 * curves do not change the place. */
SFUMATO_API int32_t sfumato_curve_source(const sfumato_document* document, uint32_t layer,
                                         uint32_t curve, size_t* byte_offset, uint32_t* subpath);

/** @}
 * @name Curves
 * Calls that change a document leave it unchanged where they fail. Their time is proportional to
 * the document's curves and stops, because they check all of it.
 * @{ */

/** Sides of a curve, as seen on the screen by someone who walks along it. */
enum sfumato_side {
  SFUMATO_LEFT = 0, /**< to the left */
  SFUMATO_RIGHT = 1 /**< to the right */
};
/** The attributes of a side. */
enum sfumato_attribute {
  SFUMATO_COLOR = 0,   /**< rows of stops are offset, red, green, blue: sRGB code values, 0 to 1 */
  SFUMATO_OPACITY = 1, /**< rows are offset, opacity from 0 to 1 */
  SFUMATO_BLUR = 2     /**< rows are offset, radius in units of the layer */
};
/** How a side handles one attribute. */
enum sfumato_kind {
  SFUMATO_OPEN = 0,    /**< lets rays pass; for a blur: no blur */
  SFUMATO_BARRIER = 1, /**< ends rays and gives no value; not for a blur */
  SFUMATO_STOPS = 2,   /**< gives the values of its stops */
  SFUMATO_PAINT = 3    /**< gives a gradient or texture; only files can make it */
};
/** The units of the offsets of stops. */
enum sfumato_space {
  SFUMATO_ARC_LENGTH = 0, /**< the share of the curve's length, 0 to 1 */
  SFUMATO_PARAMETER = 1   /**< Bezier pieces: piece i at t is i + t */
};

/** Gives the 3 n + 1 control points of a curve: f64, 2 columns, in the frame of its layer. */
SFUMATO_API int32_t sfumato_curve_points(const sfumato_document* document, uint32_t layer,
                                         uint32_t curve, sfumato_view* points);
/** Replaces the control points of a curve: `xy` are `point_count` pairs. */
SFUMATO_API int32_t sfumato_set_curve_points(sfumato_context* context, sfumato_document* document,
                                             uint32_t layer, uint32_t curve, const double* xy,
                                             size_t point_count);
/** Writes at most `capacity` stops into `rows`, each of 4 doubles for colours and of 2 for others.
 * Returns their number; 0 where there is no such side. `kind`, `space` and `rows` may be NULL. */
SFUMATO_API size_t sfumato_curve_stops(const sfumato_document* document, uint32_t layer,
                                       uint32_t curve, uint32_t side, uint32_t attribute,
                                       int32_t* kind, int32_t* space, double* rows,
                                       size_t capacity);
/** Sets an attribute of a side: SFUMATO_STOPS with rows, else SFUMATO_OPEN or SFUMATO_BARRIER. */
SFUMATO_API int32_t sfumato_set_curve_stops(sfumato_context* context, sfumato_document* document,
                                            uint32_t layer, uint32_t curve, uint32_t side,
                                            uint32_t attribute, int32_t kind, int32_t space,
                                            const double* rows, size_t row_count);
/** Returns the weight of a curve beside others, above 0 (sf:weight); 0 without such a curve. */
SFUMATO_API double sfumato_curve_weight(const sfumato_document* document, uint32_t layer,
                                        uint32_t curve);
/** Sets the weight of a curve; the default is 1. */
SFUMATO_API int32_t sfumato_set_curve_weight(sfumato_context* context, sfumato_document* document,
                                             uint32_t layer, uint32_t curve, double weight);
/** Inserts a curve with two open sides: before curve `at`, or with UINT32_MAX as the last. */
SFUMATO_API int32_t sfumato_insert_curve(sfumato_context* context, sfumato_document* document,
                                         uint32_t layer, uint32_t at, const double* xy,
                                         size_t point_count);
/** Removes a curve. */
SFUMATO_API int32_t sfumato_remove_curve(sfumato_context* context, sfumato_document* document,
                                         uint32_t layer, uint32_t curve);

/** @}
 * @name Pictures
 * @{ */

/** A solved document, independent of resolution. It keeps a copy of the document. */
typedef struct sfumato_picture sfumato_picture;

/** Solves a document.
 *
 * options: viewport, width, height, scale, detail, method=exact|rays, rays, seed, tolerance, ends,
 * no-blur, max-error, max-area, min-angle, order. width, height and scale give the size of the
 * largest output, as in sfumato_export(); detail=NUMBER [1] multiplies it. pixel-grid makes the
 * picture for images of 8 bits and that size alone, faster; other outputs refuse it. Use drags
 * where curves or stops will be dragged: exact pictures then keep the tables that quick pictures
 * start from (4 to 5 times the picture's memory), if all calls for the picture get this context.
 * drag-triangles=N keeps them only for layers of at most N triangles in all, 1 kB for each: the
 * layers dragged last, then the largest ones; always for the last one, and for the only one. Use
 * coherent for the first frame of a film: sfumato_solve_next(). */
SFUMATO_API int32_t sfumato_solve(sfumato_context* context, const sfumato_document* document,
                                  const char* options, sfumato_picture** picture);
/** Solves a document again, with the options that the picture was solved with. Solves only the
 * layers whose curves changed since the last call. The result equals sfumato_solve() bit for bit.
 * After an error the picture is unchanged.
 *
 * Set `quick` to 1 for a preview while curves move. Where curves of one layer got other points or
 * stops since the last time, and nothing else changed, the layer is not solved. Values are then
 * exact to a few code values, the mesh near the curves is as fine as it was there, and the curves
 * are drawn over the others of their layer. The first call for some curves costs up to as much as
 * solving their layer. It prepares tables that last until the next call without `quick`, or for
 * other curves. Curves that touch a hundredth of the layer's mesh are drawn on a coarse one.
 *
 * Where only the value of one stop of a colour or an opacity changed, or all stops of a list by the
 * same difference, only the first call for the stop gathers. Values are exact. After the first call
 * only SFUMATO_COLOR_VALUES or SFUMATO_OPACITY_VALUES are new.
 *
 * Where more changed, the layers to solve get exact values on a coarse mesh. The other layers keep
 * their rows. Later quick pictures of one curve or stop start from a coarse layer as from an exact
 * one, and stay as coarse. The next call without `quick` solves all layers that are not exact. */
SFUMATO_API int32_t sfumato_solve_again(sfumato_context* context, const sfumato_document* document,
                                        int32_t quick, sfumato_picture* picture);
/** Does sfumato_solve_again() with `quick` in little more than `seconds`, at least 0. Use it in a
 * loop of frames. After that time, nodes wait if the drag of this curve gathered them before, or if
 * they see more than the curve. They keep the values of the last picture, or the values without the
 * curve; SFUMATO_WAITING_NODES counts them. Called again without a change, it continues with the
 * nodes that the curve may change most, and always gathers some. `seconds` does not bound the first
 * call for a curve or a stop, nor coarse layers. */
SFUMATO_API int32_t sfumato_solve_within(sfumato_context* context, const sfumato_document* document,
                                         double seconds, sfumato_picture* picture);
/** Makes the next frame of a film from a picture solved with `coherent`: the picture of `document`,
 * with the same options. Where nothing changes, pixels differ by one code value at most. Layers
 * continue on their meshes: only curves that changed are inserted again, and the bound on the error
 * holds. A layer gets a new mesh where too much changed (docs/c-api.md), and in each call whose
 * `context` is not the one that solved the picture, which is charged for the meshes. Errors leave
 * the picture as it was. */
SFUMATO_API int32_t sfumato_solve_next(sfumato_context* context, const sfumato_document* document,
                                       sfumato_picture* picture);
/** Prepares a picture for dragging curves of a layer together: the first quick picture is then as
 * fast as later ones. Use it, for example, when a pointer is above a curve. The picture stays
 * unchanged. Where the tables that quick pictures start from were not kept, its layer is solved
 * once more. The prepared tables take memory of this context until other curves are prepared, or
 * the picture is solved again. Returns SFUMATO_BAD_INPUT without such curves, or if their layer
 * changed since it was solved. */
SFUMATO_API int32_t sfumato_expect_drag(sfumato_context* context, sfumato_picture* picture,
                                        uint32_t layer, const uint32_t* curves, size_t curve_count);
/** Writes a picture exactly, as `sfumato solve` does: docs/picture-file.md. */
SFUMATO_API int32_t sfumato_picture_write(sfumato_context* context, const sfumato_picture* picture,
                                          sfumato_bytes** bytes);
/** Reads such a file and checks all of its content: the file need not be trusted. The picture shows
 * and exports the same as the written one, to the last bit, except HTML without exact pixels. It
 * has no document: calls that need one, such as sfumato_solve_again(), return SFUMATO_BAD_USAGE.
 * The context is charged for the picture. */
SFUMATO_API int32_t sfumato_picture_read(sfumato_context* context, const void* bytes,
                                         size_t byte_count, sfumato_picture** picture);
/** Frees a picture. */
SFUMATO_API void sfumato_picture_free(sfumato_picture* picture);
/** Gives the part that was solved: x, y, width and height, in user units. */
SFUMATO_API int32_t sfumato_picture_viewport(const sfumato_picture* picture, double box[4]);
/** Returns the number of layers; the same as in the document. */
SFUMATO_API uint32_t sfumato_picture_layer_count(const sfumato_picture* picture);

/** Tables of a solved layer. They do not hold the stack, gradients, textures, and blurs finer than
 * triangles: sfumato_raster() and sfumato_export() show the complete picture. */
enum sfumato_table {
  SFUMATO_VERTICES = 0,      /**< f64, 2 columns: positions in the frame of the layer */
  SFUMATO_TRIANGLES = 1,     /**< u32, 3 columns: vertices */
  SFUMATO_CURVE_EDGES = 2,   /**< u8, 3 columns: 1 where colours may jump across the edge */
  SFUMATO_COLOR_NODES = 3,   /**< u32, 10 columns: rows of the values, as sfumato::PatchField */
  SFUMATO_COLOR_VALUES = 4,  /**< f32: 3 columns, and one for the weight of each paint */
  SFUMATO_OPACITY_NODES = 5, /**< as the colour's; no rows where the layer is opaque */
  SFUMATO_OPACITY_VALUES = 6 /**< f32: 1 column, and one for the weight of each paint */
};

/** Gives a table of a layer. It lasts until the picture is solved again or freed. */
SFUMATO_API int32_t sfumato_picture_table(const sfumato_picture* picture, uint32_t layer,
                                          uint32_t table, sfumato_view* view);
/** Gives the rows of a table that the last sfumato_solve_again() changed: ranges, from and up to,
 * ascending and apart, as u32, 2 columns. After sfumato_solve() these are all rows. While one curve
 * moves they are few, from the second quick picture on, or from the first where the layer is
 * opaque; rows between two near ones may be unchanged. Tables may have become shorter. */
SFUMATO_API int32_t sfumato_picture_changes(const sfumato_picture* picture, uint32_t layer,
                                            uint32_t table, sfumato_view* view);

/** Figures of the last call that solved, summed over the layers that it solved. Layers are solved
 * in parallel: their seconds may add up to more than the time of the call. */
enum sfumato_statistic {
  SFUMATO_CURVES = 0,                /**< diffusion curves */
  SFUMATO_SEGMENTS = 1,              /**< straight segments of the flattened curves */
  SFUMATO_SOLVED_TRIANGLES = 2,      /**< of the patch meshes */
  SFUMATO_SOLVED_VERTICES = 3,       /**< of the patch meshes */
  SFUMATO_NODES = 4,                 /**< points at which colour or opacity was gathered */
  SFUMATO_GEOMETRY_SECONDS = 5,      /**< flattening curves and sampling their attributes */
  SFUMATO_TRIANGULATION_SECONDS = 6, /**< making and refining meshes */
  SFUMATO_GATHER_SECONDS = 7,        /**< gathering at nodes, and finding triangles to refine */
  SFUMATO_WAITING_NODES = 8,         /**< in the picture: sfumato_solve_within() */
  SFUMATO_KEPT_LAYERS = 9,           /**< in a frame: unchanged layers */
  SFUMATO_CONTINUED_LAYERS = 10,     /**< in a frame: continued on the mesh of the last frame */
  SFUMATO_BEGUN_LAYERS = 11          /**< in a frame: on new meshes */
};

/** Returns one of these figures; 0 where there is no such figure. */
SFUMATO_API double sfumato_picture_statistic(const sfumato_picture* picture, uint32_t statistic);

/** Gives the response of a layer's values to a stop of a colour or an opacity, or with UINT32_MAX
 * as `stop` to all stops of that side. Use it to show a colour that changes all the time without a
 * call for each value. `response`: f32, 1 column, a row for each row of SFUMATO_COLOR_VALUES or
 * SFUMATO_OPACITY_VALUES, 0 to 1. Where the stop's value grows by d, in the space of
 * sfumato_document_interpolation(), the first 3 columns of that row grow by d times its response;
 * for an opacity the first column does.
 *
 * Preparing this costs as much as the first quick picture. The layer gets new tables
 * (sfumato_picture_changes()), which look the same and have a node for each colour that a corner
 * may get. The response lasts until the response to another stop, until the picture is freed, or
 * until it is solved again; quick pictures that only change that stop keep it. `picture` must be
 * the picture of its document, solved without `quick`. */
SFUMATO_API int32_t sfumato_stop_response(sfumato_context* context, sfumato_picture* picture,
                                          uint32_t layer, uint32_t curve, uint32_t side,
                                          uint32_t attribute, uint32_t stop,
                                          sfumato_view* response);

/** @}
 * @name Pixels and files
 * @{ */

/** Formats of pixels; 16 bits are in the machine's byte order. */
enum sfumato_pixel_format {
  SFUMATO_RGB8 = 0,  /**< 3 bytes */
  SFUMATO_RGBA8 = 1, /**< 4 bytes */
  SFUMATO_RGB16 = 2, /**< 6 bytes */
  SFUMATO_RGBA16 = 3 /**< 8 bytes */
};

/** Pixels that the caller owns: sRGB, alpha not premultiplied. */
typedef struct sfumato_image {
  void* pixels;     /**< rows from the top */
  size_t row_bytes; /**< bytes from one row to the next; at least one row of pixels */
  int32_t width;    /**< pixels */
  int32_t height;   /**< pixels */
  int32_t format;   /**< a ::sfumato_pixel_format */
} sfumato_image;

/** Draws a picture into the caller's pixels. After an error the pixels are unspecified. Bytes
 * between rows are not changed.
 * options: viewport [the picture's], background=COLOR|none [the document's; without one
 * transparent, or white where there is no alpha], dither [off], no-antialias, mesh-overlay;
 * window=X,Y,W,H: the image, which is W x H, is this part of a larger one whose size is given by
 * width, height and scale as in sfumato_export(), up to 2^24 pixels on a side. Its bytes equal that
 * part. */
SFUMATO_API int32_t sfumato_raster(sfumato_context* context, const sfumato_picture* picture,
                                   const sfumato_image* image, const char* options);
/** Makes a file of a picture: png, jpg, webp, html, pdf, eps, svg, glb, npz, ply or json, with the
 * bytes that the command writes. Warns of content that the format cannot show (sfumato_warning()).
 * In WebAssembly returns SFUMATO_UNAVAILABLE for formats that the module lacks (docs/wasm.md).
 *
 * options: width, height, scale, background; for pixels also viewport, window, depth, dither,
 * no-dither, no-antialias, mesh-overlay, quality, lossless; for others dpi, svg, force,
 * pdf-flatten, title [Sfumato]. */
SFUMATO_API int32_t sfumato_export(sfumato_context* context, const sfumato_picture* picture,
                                   const char* format, const char* options, sfumato_bytes** bytes);
/** Makes a file of the caller's pixels: png, jpg (only SFUMATO_RGB8) or webp (only 8 bits). Returns
 * SFUMATO_UNAVAILABLE in WebAssembly. options: quality, lossless. */
SFUMATO_API int32_t sfumato_encode(sfumato_context* context, const sfumato_image* image,
                                   const char* format, const char* options, sfumato_bytes** bytes);

/** Makes the data that the HTML viewer draws: the bytes of docs/viewer.md, "Payload", not deflated.
 * options: background [the document's, else white]. */
SFUMATO_API int32_t sfumato_viewer_payload(sfumato_context* context, const sfumato_picture* picture,
                                           const char* options, sfumato_bytes** bytes);
/** Makes these bytes without the meshes and fields of the layers. Use it where you draw the layers
 * from sfumato_picture_table(). The bytes keep each layer's order and the paints of its fields. The
 * time does not depend on the layers' tables. options: background [the document's, else white]. */
SFUMATO_API int32_t sfumato_picture_stack(sfumato_context* context, const sfumato_picture* picture,
                                          const char* options, sfumato_bytes** bytes);
/** Makes the tables that exact pixels of a layer are gathered from (docs/viewer.md, "Exact
 * fields"), in about the time of meshing it. Two bytes where nothing is seen, and where sides have
 * paints. Returns SFUMATO_BAD_INPUT without such a layer, SFUMATO_BAD_USAGE for one that was read.
 */
SFUMATO_API int32_t sfumato_exact_layer(sfumato_context* context, const sfumato_picture* picture,
                                        uint32_t layer, sfumato_bytes** bytes);

/** Adds the pixels of an image that the caller decoded. Documents that the context reads later use
 * them for each texture whose file consists of these `byte_count` bytes: the library then decodes
 * nothing, and the file may have any format. Both are copied, and charged to the context until it
 * is freed. `image` NULL removes the pixels for these bytes. */
SFUMATO_API int32_t sfumato_add_image(sfumato_context* context, const void* bytes,
                                      size_t byte_count, const sfumato_image* image);

/** @}
 * @name Traces
 * @{ */

/** The progress of a trace. */
typedef struct sfumato_trace_state {
  double psnr_db;          /**< colours and opacity, against the scaled picture; 0: unknown */
  double seconds;          /**< since the start */
  uint32_t round;          /**< 0: only edges of the picture; then edges that are missing */
  uint32_t round_count;    /**< largest number of rounds, including round 0 */
  uint32_t curves;         /**< including the frame along the picture's border */
  uint32_t control_points; /**< 3 n + 1 for each curve of n pieces */
  uint32_t stops;          /**< colours on all sides */
} sfumato_trace_state;

/** Receives the progress of a trace, on the thread that called: when edges are found, with rough
 * colours, and after each round. */
typedef struct sfumato_trace_watch {
  /** `drawing` is the state of the trace, borrowed until this returns. It may be read, copied,
   * written or solved, also with the trace's context. Where memory is short, rounds may pass
   * without a call. */
  void (*reached)(void* user, const sfumato_trace_state* state, const sfumato_document* drawing);
  void* user; /**< passed to `reached` */
} sfumato_trace_watch;

/** Makes a drawing of a picture, as `sfumato trace` does (docs/cli.md): curves along its edges,
 * with fitted colours and blur. The artboard is the picture, a unit a pixel. `watch` may be NULL.
 *
 * options: points=N [2000 for 640 x 480] or detail=0...1 for 250 to 16,000 of them, max-curves,
 * psnr=DB to end as soon as it is reached, smooth=PIXELS [0] of texture that curves ignore,
 * stops=few|normal|many, blur=on|off|fixed, max-side=PIXELS [1024] to scale larger pictures down,
 * seed, edges-only for a draft, no-alpha to put the picture on white, texture to add a layer of
 * the details that the curves miss (not in WebAssembly). When max-time is over, the result is the
 * drawing of the last round, without texture. */
SFUMATO_API int32_t sfumato_trace(sfumato_context* context, const sfumato_image* image,
                                  const char* options, const sfumato_trace_watch* watch,
                                  sfumato_document** document);

/** Copies a document and fits its colours to a picture laid over the artboard, so that the drawing
 * looks as similar as possible. Curves, places of stops, gradients and layers stay. Returns
 * SFUMATO_BAD_INPUT where no curve has colours.
 *
 * options: blur=on|off|fixed, where off leaves radii unchanged, max-side, seed, as in
 * sfumato_trace(); keep-colors to fit only radii; only=LAYER:CURVE,... for some curves, from 0. */
SFUMATO_API int32_t sfumato_fit_colors(sfumato_context* context, const sfumato_document* drawing,
                                       const sfumato_image* image, const char* options,
                                       sfumato_document** document);

/** @}
 * @name Fields
 * @{ */

/** The exact colours of one layer at points, without a mesh. */
typedef struct sfumato_field sfumato_field;

/** Prepares a layer. The document may be freed afterwards. Textures are averaged over a pixel of
 * the size given by the options, at the largest scale at which the layer is shown.
 *
 * options: viewport, width, height, scale, tolerance, ends, no-blur, max-error, as in
 * sfumato_solve(). */
SFUMATO_API int32_t sfumato_field_new(sfumato_context* context, const sfumato_document* document,
                                      uint32_t layer, const char* options, sfumato_field** field);
/** Frees a field. */
SFUMATO_API void sfumato_field_free(sfumato_field* field);
/** Computes colours at points. `xy` are `point_count` pairs in the frame of the layer, inside the
 * part that the viewport shows, and not on a curve. Neighbours in the list should be neighbours in
 * the plane. `rgba` receives 4 floats a point: sRGB code values, not premultiplied, and the
 * opacity; all 0 where no colour is seen. */
SFUMATO_API int32_t sfumato_field_colors(sfumato_context* context, const sfumato_field* field,
                                         const double* xy, size_t point_count, float* rgba);

/** The weight of each stop of a layer at points: the rows of a sparse matrix. Times the values of
 * the stops, they give the exact colours or opacities, in the document's interpolation space. */
typedef struct sfumato_weights sfumato_weights;

/** Prepares a layer. The document may be freed afterwards. `attribute` is SFUMATO_COLOR or
 * SFUMATO_OPACITY. Rows stay valid while the curves, their blur, and the offsets and kinds of their
 * sides do not change, and, at the free end of a curve, while its sides differ. options: as in
 * sfumato_field_new(), except ends, which are soft. */
SFUMATO_API int32_t sfumato_weights_new(sfumato_context* context, const sfumato_document* document,
                                        uint32_t layer, uint32_t attribute, const char* options,
                                        sfumato_weights** weights);
/** Frees weights. */
SFUMATO_API void sfumato_weights_free(sfumato_weights* weights);
/** Finds the rows of `point_count` points, as in sfumato_field_colors(). They replace the rows of
 * the last call, unless this call fails. Weights below `negligible`, 0 to 1, may be left out of a
 * row; the others are scaled up. The weights of a point that sees only stops add up to 1. */
SFUMATO_API int32_t sfumato_weights_at(sfumato_context* context, sfumato_weights* weights,
                                       const double* xy, size_t point_count, double negligible);
/** The tables of weights. Tables of values have 3 columns for colours, 1 for opacities. */
enum sfumato_weights_table_name {
  SFUMATO_ROW_BEGINS = 0,   /**< u32, 1 column: where the entries of each point begin, and an end */
  SFUMATO_COLUMNS = 1,      /**< u32, 1 column: of each entry, ascending in a row */
  SFUMATO_WEIGHTS = 2,      /**< f32, 1 column: of each entry */
  SFUMATO_COLUMN_STOPS = 3, /**< u32, 3 columns: the curve, side and stop of each column */
  SFUMATO_COLUMN_VALUES = 4, /**< f32: the value of each column's stop in the document */
  SFUMATO_PAINT_VALUES = 5   /**< f32: the share of gradients and textures at each point */
};
/** Gives a table. It lasts until the next sfumato_weights_at(), or until the weights are freed. */
SFUMATO_API int32_t sfumato_weights_table(const sfumato_weights* weights, uint32_t table,
                                          sfumato_view* view);
/** Converts colours, 3 numbers each, from one space of ::sfumato_interpolation to another;
 * `converted` may be `colors`. Nothing is clamped. */
SFUMATO_API int32_t sfumato_convert_colors(int32_t from, int32_t to, const double* colors,
                                           size_t color_count, double* converted);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
