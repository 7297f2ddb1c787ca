#ifndef SFUMATO_H
#define SFUMATO_H

/** @file
 * Sfumato's C interface, ABI 1: what other languages bind to. docs/c-api.md has a program.
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
 * **Errors.** What can fail returns an int32_t of ::sfumato_status_code, SFUMATO_OK = 0. What it
 * hands out through its last parameter is NULL where it fails. Reason and place wait in the context
 * until its next call. Nothing is thrown or printed.
 *
 * **Ownership.** What a function hands out as T* or through a T** is given back by the `_free` of
 * T, which takes NULL. The order does not matter: a context may be freed before what it made. No
 * block of memory changes its owner.
 *
 * **Options** are one string, "key=value key key=value": keys and values are those of the command's
 * long options (docs/cli.md). NULL and "" are the defaults. A value with blanks is quoted,
 * title="A fish", with \\" and \\\\ for a quote and a backslash in it. A key that a call does not
 * know, or a value that the key does not take, is SFUMATO_BAD_USAGE, and the text names it.
 *
 * **Views** of tables are borrowed: they last until their owner is changed or freed.
 *
 * **Threads.** A context serves one call at a time; different contexts may work at once. A
 * document, picture or field may be read by several calls while none changes it. sfumato_cancel()
 * is the one call for another thread, or for a signal handler.
 *
 * **Stability.** A library of ABI 1 serves every program that was built against an earlier header
 * of ABI 1. Structs here are final; enumerations only grow at their end.
 */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
/** Marks what the library exports. */
#define SFUMATO_API __attribute__((visibility("default")))
#else
/** Marks what the library exports. */
#define SFUMATO_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The ABI of this header. */
#define SFUMATO_ABI 1

/** The version of the library that runs, as "0.1.0". */
SFUMATO_API const char* sfumato_version(void);
/** The ABI of the library that runs, to be compared with SFUMATO_ABI. */
SFUMATO_API uint32_t sfumato_abi(void);

/** @name Errors
 * @{ */

/** What functions return. */
enum sfumato_status_code {
  SFUMATO_OK = 0,            /**< success */
  SFUMATO_BAD_INPUT = 1,     /**< the input cannot be understood or drawn */
  SFUMATO_LIMIT = 2,         /**< a limit, the budget of memory, or the time */
  SFUMATO_CANCELLED = 3,     /**< sfumato_cancel() was called */
  SFUMATO_IO = 4,            /**< the system refused to read or write */
  SFUMATO_OUT_OF_MEMORY = 5, /**< the system refused memory */
  SFUMATO_UNAVAILABLE = 6,   /**< this library or machine lacks it */
  SFUMATO_INTERNAL = 7,      /**< a mistake of the library's */
  SFUMATO_BAD_USAGE = 8      /**< a NULL, an index, a size or an option that no call takes */
};

/** @}
 * @name Contexts
 * @{ */

/** Threads, bounds on memory and time, and the last error. */
typedef struct sfumato_context sfumato_context;

/** Makes a context. NULL where memory is out. Where an option is wrong, sfumato_error_text() says
 * so at once, and every call with the context fails by it.
 *
 * options: threads=N [all cores], max-memory=MIB of work and of the documents, pictures and fields
 * that the context made [2048], max-time=SECONDS of each call [off], limit.NAME=VALUE
 * (docs/limits.md), simd=sse2|avx2|avx512 [what the machine has]. */
SFUMATO_API sfumato_context* sfumato_context_new(const char* options);
/** Gives a context back. */
SFUMATO_API void sfumato_context_free(sfumato_context* context);

/** The words of the last call's error, without its place; "" after success. Never NULL. */
SFUMATO_API const char* sfumato_error_text(const sfumato_context* context);
/** The name of the input that the last error is about, or "". Never NULL. */
SFUMATO_API const char* sfumato_error_file(const sfumato_context* context);
/** Line and column (in bytes) of the last error, from 1; 0 where unknown. Either may be NULL. */
SFUMATO_API void sfumato_error_place(const sfumato_context* context, int32_t* line,
                                     int32_t* column);
/** A warning of the last sfumato_read() or sfumato_export(), with its place; NULL past the last. */
SFUMATO_API const char* sfumato_warning(const sfumato_context* context, size_t index);

/** Hears how far work has come. `stage` is a word, as "gather"; `fraction` is from 0 to 1. It is
 * called from any thread, also from several at once, and may call sfumato_cancel() alone. */
typedef void (*sfumato_progress_fn)(void* user, const char* stage, double fraction);
/** Says who hears of progress; NULL: nobody. */
SFUMATO_API void sfumato_set_progress(sfumato_context* context, sfumato_progress_fn progress,
                                      void* user);

/** Ends the call that runs with SFUMATO_CANCELLED, within about 50 ms, and all later ones until
 * sfumato_resume(). */
SFUMATO_API void sfumato_cancel(sfumato_context* context);
/** Lets the context work again. */
SFUMATO_API void sfumato_resume(sfumato_context* context);

/** @}
 * @name Bytes and views
 * @{ */

/** Bytes of the library's, as of a file. */
typedef struct sfumato_bytes sfumato_bytes;
/** The first of them; NULL for none. */
SFUMATO_API const uint8_t* sfumato_bytes_data(const sfumato_bytes* bytes);
/** How many there are. */
SFUMATO_API size_t sfumato_bytes_size(const sfumato_bytes* bytes);
/** Gives bytes back. */
SFUMATO_API void sfumato_bytes_free(sfumato_bytes* bytes);

/** Types of the numbers in a table. */
enum sfumato_number_type {
  SFUMATO_U8 = 1,  /**< uint8_t */
  SFUMATO_U32 = 2, /**< uint32_t */
  SFUMATO_F32 = 3, /**< float */
  SFUMATO_F64 = 4  /**< double */
};

/** A table of numbers: borrowed, and not to be written to. */
typedef struct sfumato_view {
  const void* data; /**< row by row; NULL where there are no rows */
  size_t rows;      /**< how many rows there are */
  size_t row_bytes; /**< from one row to the next */
  uint32_t columns; /**< numbers of a row */
  uint32_t type;    /**< of ::sfumato_number_type */
} sfumato_view;

/** @}
 * @name Documents
 * @{ */

/** Diffusion curves as their author drew them. */
typedef struct sfumato_document sfumato_document;

/** Takes the bytes of a file from a loader; `sink` is what the loader was given. */
typedef void (*sfumato_deliver_fn)(void* sink, const void* bytes, size_t byte_count);

/** Brings the files that a document names: its textures. */
typedef struct sfumato_loader {
  /** Calls deliver(sink, bytes, byte_count) once and returns 0, or returns anything else where it
   * will not. `href` is as in the document, percent signs decoded: guard against paths that lead
   * elsewhere. */
  int32_t (*load)(void* user, const char* href, sfumato_deliver_fn deliver, void* sink);
  void* user; /**< handed to `load` */
} sfumato_loader;

/** Reads SVG or Orzan's XML, packed by gzip or not. `name` is for messages, or NULL. `loader` may
 * be NULL: a document that names a file is an error then. */
SFUMATO_API int32_t sfumato_read(sfumato_context* context, const void* bytes, size_t byte_count,
                                 const char* name, const sfumato_loader* loader,
                                 sfumato_document** document);
/** Makes a document of one layer without curves, painted once.
 *
 * options: artboard=X,Y,W,H (to be given), interpolation=srgb|linear|oklab, background=COLOR. */
SFUMATO_API int32_t sfumato_document_new(sfumato_context* context, const char* options,
                                         sfumato_document** document);
/** Copies a document, as for an undo. */
SFUMATO_API int32_t sfumato_document_copy(sfumato_context* context, const sfumato_document* from,
                                          sfumato_document** document);
/** Gives a document back. */
SFUMATO_API void sfumato_document_free(sfumato_document* document);
/** Writes a document as SVG, exactly. */
SFUMATO_API int32_t sfumato_document_write(sfumato_context* context,
                                           const sfumato_document* document, sfumato_bytes** bytes);
/** Looks for probable mistakes: one line of JSON, as `sfumato lint --json` prints it (docs/cli.md),
 * whose "file" is the name that sfumato_read() was given. Costs a mesh of every layer.
 *
 * options: verbose, for notes too. */
SFUMATO_API int32_t sfumato_lint(sfumato_context* context, const sfumato_document* document,
                                 const char* options, sfumato_bytes** json);
/** What is shown of the plane: x, y, width and height, in user units. */
SFUMATO_API int32_t sfumato_document_artboard(const sfumato_document* document, double box[4]);
/** The spaces in which colours are mixed. */
enum sfumato_interpolation {
  SFUMATO_SRGB = 0,   /**< sRGB code values, 0 to 1 */
  SFUMATO_LINEAR = 1, /**< linear light, 0 to 1 */
  SFUMATO_OKLAB = 2   /**< OKLab: L, a and b */
};
/** The space in which a document mixes colours, of ::sfumato_interpolation: that of
 * SFUMATO_COLOR_VALUES. */
SFUMATO_API int32_t sfumato_document_interpolation(const sfumato_document* document);
/** How many layers there are. */
SFUMATO_API uint32_t sfumato_layer_count(const sfumato_document* document);
/** How many diffusion curves a layer has. */
SFUMATO_API uint32_t sfumato_curve_count(const sfumato_document* document, uint32_t layer);
/** The id of a layer, perhaps ""; NULL where there is no such layer. */
SFUMATO_API const char* sfumato_layer_id(const sfumato_document* document, uint32_t layer);
/** The id of a curve, perhaps ""; NULL where there is no such curve. */
SFUMATO_API const char* sfumato_curve_id(const sfumato_document* document, uint32_t layer,
                                         uint32_t curve);

/** Where in the text that sfumato_read() was given a curve stands: bytes before the `<` of its
 * element, a shape, also where a `use` copies it; and which of the element's subpaths it is, from
 * 0, where movements do not count after which nothing is drawn. 0 and 0 where that is not known: of
 * curves that were inserted, of Orzan's XML, and of text that is packed or not UTF-8. Either may be
 * NULL. Edits of curves do not change it. */
SFUMATO_API int32_t sfumato_curve_source(const sfumato_document* document, uint32_t layer,
                                         uint32_t curve, size_t* byte_offset, uint32_t* subpath);

/** @}
 * @name Curves
 * Calls that change a document leave it as it was where they fail, and cost time in proportion to
 * the document's curves and stops: all of it is checked.
 * @{ */

/** Sides of a curve, as seen on the screen by who walks along it. */
enum sfumato_side {
  SFUMATO_LEFT = 0, /**< to the left */
  SFUMATO_RIGHT = 1 /**< to the right */
};

/** What a side may bear. */
enum sfumato_attribute {
  SFUMATO_COLOR = 0,   /**< rows of stops are offset, red, green, blue: sRGB code values, 0 to 1 */
  SFUMATO_OPACITY = 1, /**< rows are offset, opacity from 0 to 1 */
  SFUMATO_BLUR = 2     /**< rows are offset, radius in units of the layer */
};

/** What a side is to one attribute. */
enum sfumato_kind {
  SFUMATO_OPEN = 0,    /**< lets rays pass; for a blur: none */
  SFUMATO_BARRIER = 1, /**< ends rays and gives nothing; not of a blur */
  SFUMATO_STOPS = 2,   /**< gives what its stops say */
  SFUMATO_PAINT = 3    /**< gives a gradient or texture, which only files make */
};

/** What the offsets of stops count. */
enum sfumato_space {
  SFUMATO_ARC_LENGTH = 0, /**< the share of the curve's length, 0 to 1 */
  SFUMATO_PARAMETER = 1   /**< Bezier pieces: piece i at t is i + t */
};

/** The 3 n + 1 control points of a curve: f64, 2 columns, in the frame of its layer. */
SFUMATO_API int32_t sfumato_curve_points(const sfumato_document* document, uint32_t layer,
                                         uint32_t curve, sfumato_view* points);
/** Moves a curve: `xy` are `point_count` pairs. */
SFUMATO_API int32_t sfumato_set_curve_points(sfumato_context* context, sfumato_document* document,
                                             uint32_t layer, uint32_t curve, const double* xy,
                                             size_t point_count);
/** Writes at most `capacity` stops into `rows`, of 4 doubles for colours and of 2 for others, and
 * returns their number; 0 where there is no such side. `kind`, `space` and `rows` may be NULL. */
SFUMATO_API size_t sfumato_curve_stops(const sfumato_document* document, uint32_t layer,
                                       uint32_t curve, uint32_t side, uint32_t attribute,
                                       int32_t* kind, int32_t* space, double* rows,
                                       size_t capacity);
/** Sets what a side bears: SFUMATO_STOPS with rows, or SFUMATO_OPEN or SFUMATO_BARRIER without. */
SFUMATO_API int32_t sfumato_set_curve_stops(sfumato_context* context, sfumato_document* document,
                                            uint32_t layer, uint32_t curve, uint32_t side,
                                            uint32_t attribute, int32_t kind, int32_t space,
                                            const double* rows, size_t row_count);
/** How strongly a curve counts beside others, above 0: sf:weight. 0 where there is none. */
SFUMATO_API double sfumato_curve_weight(const sfumato_document* document, uint32_t layer,
                                        uint32_t curve);
/** Sets that weight; 1 is that of a curve without one. */
SFUMATO_API int32_t sfumato_set_curve_weight(sfumato_context* context, sfumato_document* document,
                                             uint32_t layer, uint32_t curve, double weight);
/** Adds a curve whose sides bear nothing: before curve `at`, or with UINT32_MAX as the last. */
SFUMATO_API int32_t sfumato_insert_curve(sfumato_context* context, sfumato_document* document,
                                         uint32_t layer, uint32_t at, const double* xy,
                                         size_t point_count);
/** Takes a curve away. */
SFUMATO_API int32_t sfumato_remove_curve(sfumato_context* context, sfumato_document* document,
                                         uint32_t layer, uint32_t curve);

/** @}
 * @name Pictures
 * @{ */

/** A solved document, of no resolution. It keeps a copy of the document. */
typedef struct sfumato_picture sfumato_picture;

/** Solves a document.
 *
 * options: viewport, width, height, scale, detail, method=exact|rays, rays, seed, tolerance, ends,
 * no-blur, max-error, max-area, min-angle, order. width, height and scale say how large the largest
 * output will be, as in sfumato_export(); detail=NUMBER [1] multiplies it. drags: exact pictures
 * keep what quick ones of a curve or a stop begin from, in four to five times the memory of the
 * picture, if all calls for it get this context. Without this option they do so from the first such
 * quick picture on. drag-triangles=N: the same for layers of no more than N triangles in all, those
 * that were dragged last and then the largest ones, and for the last one, or the only one, in any
 * case: about 1 kB a triangle. coherent: the first frame of a film, sfumato_solve_next(). */
SFUMATO_API int32_t sfumato_solve(sfumato_context* context, const sfumato_document* document,
                                  const char* options, sfumato_picture** picture);
/** Makes a picture that of `document`, with the options that it was solved with: only layers whose
 * curves differ from those of the last time are solved. The result equals that of sfumato_solve(),
 * bit for bit. Where it fails the picture is as before.
 *
 * `quick`, unless 0: a picture for looking at while a curve moves. Where one curve of the document
 * was set to other points or stops since the last time, and nothing else, its layer is not solved:
 * values are exact to a few code values, the mesh is as fine as it was where the curve has come
 * to, and the curve is drawn over the others of its layer. The first time for a curve costs up to
 * what solving its layer does; what that prepares lasts until the next call without `quick`, or for
 * another curve. A curve on which a hundredth of the layer's mesh lies is drawn on a coarse one.
 *
 * Where all that changed is the value of one stop of a colour or an opacity, or of all stops of a
 * list by the same difference, nothing is gathered but the first time for the stop: values are
 * exact, and but for the first time SFUMATO_COLOR_VALUES or SFUMATO_OPACITY_VALUES alone are new.
 *
 * Where more than that has changed, layers that would be solved are solved roughly: values are
 * exact, on a coarse mesh. The other layers stay as they are, exact ones exact and without new
 * rows. Later quick pictures of one curve or stop begin from a rough layer as they do from an exact
 * one, and stay as coarse. The next call without `quick` solves anew what is not exact. */
SFUMATO_API int32_t sfumato_solve_again(sfumato_context* context, const sfumato_document* document,
                                        int32_t quick, sfumato_picture* picture);
/** sfumato_solve_again() with `quick`, in little more than this time, where that can be: once
 * `seconds`, at least 0, are over, values wait that were gathered before while this curve moved, or
 * that see more than the curve. They are those of the last picture, or those without the curve;
 * SFUMATO_WAITING_NODES counts them. Called again while nothing has changed, it goes on with them,
 * those first that the curve may change most, and with some even if there is no time. `seconds`
 * does not bound what has to be done first: the first time for a curve or a stop, and layers that
 * are solved roughly. */
SFUMATO_API int32_t sfumato_solve_within(sfumato_context* context, const sfumato_document* document,
                                         double seconds, sfumato_picture* picture);
/** Makes a picture, which has to be one of `coherent`, the next frame of its film: that of
 * `document`, with the same options. Where nothing changes pixels differ by one code value at most:
 * layers go on with their meshes, in which only curves that changed are placed anew, and the bound
 * on the error holds. Where too little is as it was (docs/c-api.md) a layer is begun anew, and so
 * it is each time where `context` is not that which solved the picture, which is charged for the
 * meshes. Where it fails the picture is as before. */
SFUMATO_API int32_t sfumato_solve_next(sfumato_context* context, const sfumato_document* document,
                                       sfumato_picture* picture);
/** Prepares a picture for quick ones in which this curve moves, so that the first of them comes as
 * soon as the others: when a pointer is above the curve, say. The picture stays as it is. Where
 * what they begin from was not kept, its layer is solved once more. What is prepared holds memory
 * of this context until another curve is, or the picture is solved again. Fails with
 * SFUMATO_BAD_INPUT where there is no such curve, or its layer was not solved since it changed. */
SFUMATO_API int32_t sfumato_expect_drag(sfumato_context* context, sfumato_picture* picture,
                                        uint32_t layer, uint32_t curve);
/** Writes a picture as it is, exactly, as `sfumato solve` does: docs/picture-file.md. */
SFUMATO_API int32_t sfumato_picture_write(sfumato_context* context, const sfumato_picture* picture,
                                          sfumato_bytes** bytes);
/** Reads such a file, whose content is checked as that of a stranger. The picture shows and exports
 * what the one that was written does, to the last bit, but HTML without exact pixels. It follows no
 * document: what needs one, as to solve it again, is SFUMATO_BAD_USAGE. It is charged. */
SFUMATO_API int32_t sfumato_picture_read(sfumato_context* context, const void* bytes,
                                         size_t byte_count, sfumato_picture** picture);
/** Gives a picture back. */
SFUMATO_API void sfumato_picture_free(sfumato_picture* picture);
/** The part that was solved: x, y, width and height, in user units. */
SFUMATO_API int32_t sfumato_picture_viewport(const sfumato_picture* picture, double box[4]);
/** How many layers there are; as many as the document has. */
SFUMATO_API uint32_t sfumato_picture_layer_count(const sfumato_picture* picture);

/** Tables of a solved layer. How layers are stacked, gradients, textures and blurs finer than
 * triangles are not in them: sfumato_raster() and sfumato_export() show a picture as it is. */
enum sfumato_table {
  SFUMATO_VERTICES = 0,      /**< f64, 2 columns: positions in the frame of the layer */
  SFUMATO_TRIANGLES = 1,     /**< u32, 3 columns: vertices */
  SFUMATO_CURVE_EDGES = 2,   /**< u8, 3 columns: 1 where colours may jump across the edge */
  SFUMATO_COLOR_NODES = 3,   /**< u32, 10 columns: rows of the values, as sfumato::PatchField */
  SFUMATO_COLOR_VALUES = 4,  /**< f32: 3 columns, and one for the weight of each paint */
  SFUMATO_OPACITY_NODES = 5, /**< as the colour's; no rows where the layer is opaque */
  SFUMATO_OPACITY_VALUES = 6 /**< f32: 1 column, and one for the weight of each paint */
};

/** A table of a layer, which lasts until the picture is solved again or freed. */
SFUMATO_API int32_t sfumato_picture_table(const sfumato_picture* picture, uint32_t layer,
                                          uint32_t table, sfumato_view* view);
/** The rows of a table that the last sfumato_solve_again() made anew: ranges, from and up to,
 * ascending and apart, as u32, 2 columns; all rows after sfumato_solve(). While one curve moves
 * these are few, from the second quick picture on or, where the layer is opaque, from the first,
 * and others are what they were, but for rows between near ones. Tables may have become shorter. */
SFUMATO_API int32_t sfumato_picture_changes(const sfumato_picture* picture, uint32_t layer,
                                            uint32_t table, sfumato_view* view);

/** What the last call that solved or went on did, summed over the layers that it solved. Layers are
 * solved side by side: their seconds may be more than those of the call. */
enum sfumato_statistic {
  SFUMATO_CURVES = 0,                /**< diffusion curves */
  SFUMATO_SEGMENTS = 1,              /**< straight segments of the flattened curves */
  SFUMATO_SOLVED_TRIANGLES = 2,      /**< of the patch meshes */
  SFUMATO_SOLVED_VERTICES = 3,       /**< of the patch meshes */
  SFUMATO_NODES = 4,                 /**< points at which colour or opacity was gathered */
  SFUMATO_GEOMETRY_SECONDS = 5,      /**< curves flattened, and their attributes sampled */
  SFUMATO_TRIANGULATION_SECONDS = 6, /**< meshes and their refinement */
  SFUMATO_GATHER_SECONDS = 7,        /**< at nodes, and to find what has to be refined */
  SFUMATO_WAITING_NODES = 8,         /**< of the picture: sfumato_solve_within() */
  SFUMATO_KEPT_LAYERS = 9,           /**< of a frame: nothing of them changed */
  SFUMATO_CONTINUED_LAYERS = 10,     /**< of a frame: on the mesh of the one before */
  SFUMATO_BEGUN_LAYERS = 11          /**< of a frame: on new meshes */
};

/** One of these numbers; 0 where there is no such. */
SFUMATO_API double sfumato_picture_statistic(const sfumato_picture* picture, uint32_t statistic);

/** How much the values of a layer answer to a stop of a colour or an opacity; with UINT32_MAX as
 * `stop` to all stops of that side. `response`: f32, 1 column, a row for each of
 * SFUMATO_COLOR_VALUES or SFUMATO_OPACITY_VALUES, 0 to 1. Where the stop's value grows by d, in the
 * space that sfumato_document_interpolation() tells, the first 3 columns of that row grow by d
 * times its response, or of an opacity the first: who draws the values may add that by himself,
 * without a call for each colour.
 *
 * Preparing this costs as much as the first quick picture. The layer gets tables of its own
 * (sfumato_picture_changes()), which show what it showed and have a node for each colour that a
 * corner may come to have. The response lasts until the picture is solved again, but for quick
 * pictures in which that stop has another value, until the response to another stop, or until it is
 * freed. `picture` is to be that of its document, solved without `quick`. */
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

/** Pixels of the caller's: sRGB, alpha not premultiplied. */
typedef struct sfumato_image {
  void* pixels;     /**< rows from the top */
  size_t row_bytes; /**< from one row to the next; at least those of its pixels */
  int32_t width;    /**< pixels */
  int32_t height;   /**< pixels */
  int32_t format;   /**< of ::sfumato_pixel_format */
} sfumato_image;

/** Draws a picture into the caller's pixels, which are unspecified where it fails; bytes between
 * rows are left alone.
 * options: viewport [the picture's], background=COLOR|none [the document's; without one
 * transparent, or white where there is no alpha], dither [not], no-antialias, mesh-overlay;
 * window=X,Y,W,H: the image, which is W x H, is this part of one that width, height and scale say
 * as in sfumato_export(), up to 2^24 pixels on a side, and has the bytes that stand there. */
SFUMATO_API int32_t sfumato_raster(sfumato_context* context, const sfumato_picture* picture,
                                   const sfumato_image* image, const char* options);
/** Makes a file of a picture: png, jpg, webp, html, pdf, eps, svg, glb, npz, ply or json, with the
 * bytes that the command writes. What the format cannot show is a warning (sfumato_warning()).
 * SFUMATO_UNAVAILABLE in WebAssembly.
 *
 * options: width, height, scale, background; of pixels also viewport, window, depth, dither,
 * no-dither, no-antialias, mesh-overlay, quality, lossless; of others dpi, svg, force, pdf-flatten,
 * title [Sfumato]. */
SFUMATO_API int32_t sfumato_export(sfumato_context* context, const sfumato_picture* picture,
                                   const char* format, const char* options, sfumato_bytes** bytes);
/** Makes a file of the caller's pixels: png, jpg (SFUMATO_RGB8 alone) or webp (8 bits alone).
 * SFUMATO_UNAVAILABLE in WebAssembly. options: quality, lossless. */
SFUMATO_API int32_t sfumato_encode(sfumato_context* context, const sfumato_image* image,
                                   const char* format, const char* options, sfumato_bytes** bytes);

/** Makes what the HTML viewer draws, the bytes of docs/viewer.md, "Payload", not deflated. options:
 * background [the document's, else white]. */
SFUMATO_API int32_t sfumato_viewer_payload(sfumato_context* context, const sfumato_picture* picture,
                                           const char* options, sfumato_bytes** bytes);
/** Makes those bytes without the layers' meshes and fields, for who draws these from
 * sfumato_picture_table(); of each layer its order and the paints of its fields remain. Its time
 * does not depend on the layers' tables. options: background [the document's, else white]. */
SFUMATO_API int32_t sfumato_picture_stack(sfumato_context* context, const sfumato_picture* picture,
                                          const char* options, sfumato_bytes** bytes);
/** Makes what exact pixels of a layer are gathered from (docs/viewer.md, "Exact fields"), in about
 * the time of meshing it. Two bytes where nothing is seen, and where sides have paints.
 * SFUMATO_BAD_INPUT without such a layer; SFUMATO_BAD_USAGE for a picture that was read. */
SFUMATO_API int32_t sfumato_exact_layer(sfumato_context* context, const sfumato_picture* picture,
                                        uint32_t layer, sfumato_bytes** bytes);

/** Hands in the pixels of an image that the caller has decoded: where a document that the context
 * reads later has a texture whose file is these `byte_count` bytes, these are its pixels. The
 * library then decodes nothing, and the file may be of any kind. Both are copied, and charged to
 * the context until it is freed. `image` NULL: forgets the pixels for these bytes. */
SFUMATO_API int32_t sfumato_add_image(sfumato_context* context, const void* bytes,
                                      size_t byte_count, const sfumato_image* image);

/** @}
 * @name Traces
 * @{ */

/** What a trace has reached. */
typedef struct sfumato_trace_state {
  double psnr_db;          /**< to the picture as it is looked at; 0: not known yet */
  double seconds;          /**< since the beginning */
  uint32_t round;          /**< 0: edges of the picture alone; then edges of what is missing */
  uint32_t round_count;    /**< rounds that there will be at most, with round 0 */
  uint32_t curves;         /**< with the frame along the picture's border */
  uint32_t control_points; /**< 3 n + 1 of each curve of n pieces */
  uint32_t stops;          /**< colours on all sides */
} sfumato_trace_state;

/** Is told what a trace has reached, by the thread that called: when edges were found, whose
 * colours are rough, and after each round. */
typedef struct sfumato_trace_watch {
  /** `drawing` is what the trace has made, borrowed until this returns: to be read, copied, written
   * or solved, with the trace's context too. It may be told of no round where memory is short. */
  void (*reached)(void* user, const sfumato_trace_state* state, const sfumato_document* drawing);
  void* user; /**< handed to `reached` */
} sfumato_trace_watch;

/** Makes a drawing of a picture, as `sfumato trace` does (docs/cli.md): curves along its edges,
 * whose colours and blur are fitted. The artboard is the picture, a unit to a pixel. `watch` may be
 * NULL.
 *
 * options: points=N [2000 for 640 x 480] or detail=0...1 for 250 to 16,000 of them, max-curves,
 * psnr=DB ends as soon as it is reached, smooth=PIXELS [0] of texture that no curve follows,
 * stops=few|normal|many, blur=on|off|fixed, max-side=PIXELS [1024] at which a larger picture is
 * looked at, seed, edges-only for a draft, no-alpha for transparent pictures as on white, texture
 * for a layer of what the curves miss (which WebAssembly cannot write). */
SFUMATO_API int32_t sfumato_trace(sfumato_context* context, const sfumato_image* image,
                                  const char* options, const sfumato_trace_watch* watch,
                                  sfumato_document** document);

/** Makes a copy of a document whose curves have the colours of a picture that is laid over the
 * artboard: those with which it looks most like it. Curves, places of stops, gradients and layers
 * stay. SFUMATO_BAD_INPUT where no curve has colours.
 *
 * options: blur=on|off|fixed, where off leaves radii as they are, max-side, seed, as of
 * sfumato_trace(); keep-colors to fit radii alone; only=LAYER:CURVE,... to fit these curves,
 * numbers from 0, and leave others as they are. */
SFUMATO_API int32_t sfumato_fit_colors(sfumato_context* context, const sfumato_document* drawing,
                                       const sfumato_image* image, const char* options,
                                       sfumato_document** document);

/** @}
 * @name Fields
 * @{ */

/** The exact colours of one layer at points, without a mesh. */
typedef struct sfumato_field sfumato_field;

/** Prepares a layer; the document is not needed afterwards. Textures are averaged over a pixel of
 * the size that the options say, at the largest scale at which the layer is shown.
 *
 * options: viewport, width, height, scale, tolerance, ends, no-blur, max-error, as of
 * sfumato_solve(). */
SFUMATO_API int32_t sfumato_field_new(sfumato_context* context, const sfumato_document* document,
                                      uint32_t layer, const char* options, sfumato_field** field);
/** Gives a field back. */
SFUMATO_API void sfumato_field_free(sfumato_field* field);
/** Computes colours: `xy` are `point_count` pairs in the frame of the layer, inside what the
 * viewport shows of it, and not on a curve; neighbours in the list should be neighbours in the
 * plane. `rgba` receives 4 floats a point: sRGB code values, not premultiplied, and the opacity;
 * all 0 where no colour is seen. */
SFUMATO_API int32_t sfumato_field_colors(sfumato_context* context, const sfumato_field* field,
                                         const double* xy, size_t point_count, float* rgba);

/** How much each stop of a layer counts at points: the rows of a sparse matrix. Times the values of
 * the stops they are the exact colours, or opacities, in the space in which the document mixes. */
typedef struct sfumato_weights sfumato_weights;

/** Prepares a layer; the document is not needed afterwards. `attribute`: SFUMATO_COLOR or
 * SFUMATO_OPACITY. What a row says holds as long as the curves, their blur, and the offsets and
 * kinds of their sides stay as they are, and, at the free end of a curve, while its sides differ.
 * options: as of sfumato_field_new(), but for ends, which are soft. */
SFUMATO_API int32_t sfumato_weights_new(sfumato_context* context, const sfumato_document* document,
                                        uint32_t layer, uint32_t attribute, const char* options,
                                        sfumato_weights** weights);
/** Gives weights back. */
SFUMATO_API void sfumato_weights_free(sfumato_weights* weights);
/** Finds the rows of `point_count` points, as of sfumato_field_colors(), in the place of those
 * before; where it fails these stay. What counts less than `negligible`, 0 to 1, for a point may be
 * left out; the rest is scaled up. The weights of a point that sees stops alone add up to 1. */
SFUMATO_API int32_t sfumato_weights_at(sfumato_context* context, sfumato_weights* weights,
                                       const double* xy, size_t point_count, double negligible);
/** Tables of weights. Those of values have 3 columns for colours, 1 for opacities. */
enum sfumato_weights_table_name {
  SFUMATO_ROW_BEGINS = 0, /**< u32, 1 column: for each point where its entries begin, and an end */
  SFUMATO_COLUMNS = 1,    /**< u32, 1 column: of each entry, ascending in a row */
  SFUMATO_WEIGHTS = 2,    /**< f32, 1 column: of each entry */
  SFUMATO_COLUMN_STOPS = 3,  /**< u32, 3 columns: the curve, the side and the stop of each column */
  SFUMATO_COLUMN_VALUES = 4, /**< f32: the value that each column's stop had in the document */
  SFUMATO_PAINT_VALUES = 5   /**< f32: for each point what gradients and textures add to it */
};
/** A table, which lasts until rows are found anew, or the weights are freed. */
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
