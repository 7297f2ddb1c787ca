#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>

#include "capi/handles.hpp"
#include "cli/run_command.hpp"

/// The results of the calls for good input.
namespace sfumato::test {
namespace {

void move_first_point(sfumato_context* c, sfumato_document* document, std::uint32_t layer,
                      std::uint32_t curve) {
  sfumato_view view{};
  ASSERT_EQ(sfumato_curve_points(document, layer, curve, &view), SFUMATO_OK);
  ASSERT_EQ(view.columns, 2u);
  std::vector<double> xy(static_cast<const double*>(view.data),
                         static_cast<const double*>(view.data) + 2 * view.rows);
  for (double& number : xy) number += 0.75;
  ASSERT_EQ(sfumato_set_curve_points(c, document, layer, curve, xy.data(), view.rows), SFUMATO_OK);
}

TEST(CSolve, again_gives_the_bits_of_a_fresh_solution) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("portrait.svg"));
  sfumato_document* d = document.get();
  const PictureHandle picture = solve(c, d, "max-error=4");
  const double rows[] = {0, 1, 0, 0, 1, 0, 1, 0};
  const auto expect_fresh = [&](const char* after) {
    ASSERT_EQ(sfumato_solve_again(c, d, 0, picture.get()), SFUMATO_OK) << after;
    EXPECT_EQ(tables_of(picture.get()), tables_of(solve(c, d, "max-error=4").get())) << after;
  };
  move_first_point(c, d, 0, 0);
  expect_fresh("a move");
  const std::uint32_t last = sfumato_layer_count(d) - 1;
  ASSERT_EQ(sfumato_set_curve_stops(c, d, last, 0, SFUMATO_LEFT, SFUMATO_COLOR, SFUMATO_STOPS,
                                    SFUMATO_ARC_LENGTH, rows, 2),
            SFUMATO_OK);
  expect_fresh("a colour");
  ASSERT_EQ(sfumato_remove_curve(c, d, last, 0), SFUMATO_OK);
  expect_fresh("a removal");
  const DocumentHandle other = read_text(c, example("evening.xml"));
  ASSERT_EQ(sfumato_solve_again(c, other.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_EQ(tables_of(picture.get()), tables_of(solve(c, other.get(), "max-error=4").get()));
}

TEST(CSolve, again_names_the_layers_that_are_new) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("portrait.svg"));
  ASSERT_GT(sfumato_layer_count(document.get()), 1u);
  const PictureHandle picture = solve(c, document.get(), "max-error=off");
  const auto new_rows = [&](std::uint32_t layer) {
    sfumato_view view{}, table{};
    EXPECT_EQ(sfumato_picture_changes(picture.get(), layer, SFUMATO_TRIANGLES, &view), SFUMATO_OK);
    EXPECT_EQ(sfumato_picture_table(picture.get(), layer, SFUMATO_TRIANGLES, &table), SFUMATO_OK);
    if (view.rows == 0) return false;
    const auto* rows = static_cast<const std::uint32_t*>(view.data);
    EXPECT_EQ(rows[0], 0u);
    EXPECT_EQ(rows[1], table.rows);
    return true;
  };
  EXPECT_TRUE(new_rows(0) && new_rows(1));
  move_first_point(c, document.get(), 1, 0);
  ASSERT_EQ(sfumato_solve_again(c, document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_FALSE(new_rows(0));
  EXPECT_TRUE(new_rows(1));
}

TEST(CSolve, counts_what_it_solved_and_times_the_steps) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("portrait.svg"));
  const PictureHandle picture = solve(c, document.get(), "max-error=off");
  const auto of_picture = [&](sfumato_statistic which) {
    return sfumato_picture_statistic(picture.get(), which);
  };
  double curves = 0, triangles = 0;
  for (std::uint32_t layer = 0; layer < sfumato_layer_count(document.get()); ++layer) {
    sfumato_view view{};
    ASSERT_EQ(sfumato_picture_table(picture.get(), layer, SFUMATO_TRIANGLES, &view), SFUMATO_OK);
    triangles += static_cast<double>(view.rows);
    curves += sfumato_curve_count(document.get(), layer);
  }
  EXPECT_EQ(of_picture(SFUMATO_CURVES), curves);
  EXPECT_EQ(of_picture(SFUMATO_SOLVED_TRIANGLES), triangles);
  const double nodes = of_picture(SFUMATO_NODES);
  for (std::uint32_t i = SFUMATO_SEGMENTS; i <= SFUMATO_GATHER_SECONDS; ++i)
    EXPECT_GT(sfumato_picture_statistic(picture.get(), i), 0) << i;
  move_first_point(c, document.get(), 1, 0);
  ASSERT_EQ(sfumato_solve_again(c, document.get(), 1, picture.get()), SFUMATO_OK);
  EXPECT_GT(of_picture(SFUMATO_NODES), 0);
  EXPECT_LT(of_picture(SFUMATO_NODES), nodes / 10) << "of one curve's frame";
  ASSERT_EQ(sfumato_solve_again(c, document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_EQ(of_picture(SFUMATO_CURVES), sfumato_curve_count(document.get(), 1)) << "of one layer";
  ASSERT_EQ(sfumato_solve_again(c, document.get(), 1, picture.get()), SFUMATO_OK);
  EXPECT_EQ(of_picture(SFUMATO_NODES), 0) << "nothing has changed";
}

TEST(CSolve, that_fails_leaves_the_picture_as_it_was) {
  const ContextHandle context = context_of(), small = context_of("threads=1 limit.segments=2");
  const DocumentHandle document = read_text(context.get(), example("evening.xml"));
  const PictureHandle picture = solve(context.get(), document.get());
  const std::string before = tables_of(picture.get());
  move_first_point(context.get(), document.get(), 0, 0);
  EXPECT_EQ(sfumato_solve_again(small.get(), document.get(), 0, picture.get()), SFUMATO_LIMIT);
  EXPECT_EQ(tables_of(picture.get()), before);
  EXPECT_EQ(sfumato_solve_again(context.get(), document.get(), 0, picture.get()), SFUMATO_OK);
  EXPECT_EQ(tables_of(picture.get()), tables_of(solve(context.get(), document.get()).get()));
}

TEST(CFiles, are_those_of_the_command) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const std::string text = example("evening.xml");
  const DocumentHandle document = read_text(c, text);
  struct Case {
    const char* format;
    const char* solving;
    const char* writing;
    std::vector<std::string> arguments;
  };
  const std::vector<Case> cases{
      {"png", "pixel-grid", "", {}},
      {"png", "pixel-grid width=200", "width=200 no-dither", {"--width", "200", "--no-dither"}},
      {"png",
       "scale=0.5 max-error=0.25",
       "scale=0.5 depth=16",
       {"--scale", "0.5", "--depth", "16"}},
      {"png", "pixel-grid", "background=none", {"--background", "none"}},
      {"jpg", "pixel-grid", "quality=70", {"--quality", "70"}},
      {"webp", "pixel-grid", "lossless background=gold", {"--lossless", "--background", "gold"}},
      {"pdf", "detail=2", "", {}},
      {"pdf",
       "detail=2",
       "title=\"A b\" background=gold",
       {"--title", "A b", "--background", "gold"}},
      {"html", "detail=2", "", {}},
      {"eps", "detail=2", "", {}},
      {"svg", "detail=2", "", {}},
      {"svg", "", "svg=vector force", {"--svg", "vector", "--force"}},
      {"glb", "detail=2", "dpi=100", {"--dpi", "100"}},
      {"npz", "", "", {}},
      {"ply", "scale=0.5", "", {"--scale", "0.5"}},
      {"json", "", "", {}}};
  for (const Case& one : cases) {
    const PictureHandle picture = solve(c, document.get(), one.solving);
    sfumato_bytes* bytes = nullptr;
    ASSERT_EQ(sfumato_export(c, picture.get(), one.format, one.writing, &bytes), SFUMATO_OK)
        << sfumato_error_text(c);
    const BytesHandle file(bytes);
    std::vector<std::string> arguments{"render", "-", "-o", "-", "--format", one.format, "--quiet"};
    arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
    const CommandResult result = run_sfumato(arguments, text);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(text_of(file.get()) == result.out) << one.format << ' ' << one.writing;
  }
}

TEST(CViewerPayload, is_of_the_version_that_is_documented_and_has_the_background) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const PictureHandle picture = solve(c, document.get());
  const auto payload = [&](const char* options) {
    sfumato_bytes* bytes = nullptr;
    EXPECT_EQ(sfumato_viewer_payload(c, picture.get(), options, &bytes), SFUMATO_OK);
    return text_of(BytesHandle(bytes).get());
  };
  const auto background = [&](const char* options) {
    constexpr std::size_t kBackgroundAt = 8 + 8 * sizeof(double) + 1;
    std::array<float, 3> color{};
    std::memcpy(color.data(), payload(options).data() + kBackgroundAt, sizeof color);
    return color;
  };
  EXPECT_EQ(payload("").substr(0, 8), "SFUMATO\x01");
  EXPECT_EQ(background("background=#00ff00"), (std::array<float, 3>{0, 1, 0}));
  EXPECT_EQ(background(""), (std::array<float, 3>{1, 1, 1}));
  EXPECT_EQ(background("background=none"), (std::array<float, 3>{1, 1, 1}));
  sfumato_bytes* none = nullptr;
  EXPECT_EQ(sfumato_viewer_payload(c, picture.get(), "width=9", &none), SFUMATO_BAD_USAGE);
  const ContextHandle few = context_of("limit.viewer-triangles=1");
  EXPECT_EQ(sfumato_viewer_payload(few.get(), picture.get(), "", &none), SFUMATO_LIMIT);
}

TEST(CPictureStack, is_the_payload_around_the_layers_and_does_not_grow_with_them) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const auto bytes_of = [&](auto call, const sfumato_picture* picture) {
    sfumato_bytes* bytes = nullptr;
    EXPECT_EQ(call(c, picture, "background=#00ff00", &bytes), SFUMATO_OK);
    return text_of(BytesHandle(bytes).get());
  };
  const PictureHandle coarse = solve(c, document.get(), "max-error=8");
  const PictureHandle fine = solve(c, document.get(), "max-error=1");
  const std::string stack = bytes_of(sfumato_picture_stack, coarse.get());
  EXPECT_EQ(stack.substr(0, 8), "SFUMATO\x81");
  EXPECT_TRUE(stack == bytes_of(sfumato_picture_stack, fine.get()));
  const std::string payload = bytes_of(sfumato_viewer_payload, coarse.get());
  EXPECT_LT(payload.size(), bytes_of(sfumato_viewer_payload, fine.get()).size());
  // The boxes, the interpolation and the background; then, after the layers, an instance, whose
  // blend mode is its last byte.
  EXPECT_EQ(stack.substr(8, 77), payload.substr(8, 77));
  EXPECT_EQ(stack.substr(stack.size() - 54), payload.substr(payload.size() - 54));
}

TEST(CPictureStack, takes_what_the_viewer_could_not_and_no_unknown_option) {
  const ContextHandle few = context_of("limit.viewer-triangles=1");
  sfumato_context* c = few.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const PictureHandle picture = solve(c, document.get());
  sfumato_bytes* bytes = nullptr;
  EXPECT_EQ(sfumato_picture_stack(c, picture.get(), "width=9", &bytes), SFUMATO_BAD_USAGE);
  EXPECT_EQ(bytes, nullptr);
  EXPECT_EQ(sfumato_picture_stack(c, picture.get(), "", &bytes), SFUMATO_OK);
  const BytesHandle stack(bytes);
}

TEST(CExactLayer, is_of_what_was_solved_last) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const PictureHandle picture = solve(c, document.get());
  const auto exact = [&](std::int32_t expected = SFUMATO_OK, std::uint32_t layer = 0) {
    sfumato_bytes* bytes = nullptr;
    EXPECT_EQ(sfumato_exact_layer(c, picture.get(), layer, &bytes), expected);
    return bytes ? text_of(BytesHandle(bytes).get()) : "";
  };
  const std::string before = exact();
  EXPECT_EQ(before.substr(0, 2), "\x01\x02");
  EXPECT_TRUE(exact() == before);
  EXPECT_EQ(exact(SFUMATO_BAD_INPUT, 1), "");
  sfumato_view view{};
  ASSERT_EQ(sfumato_curve_points(document.get(), 0, 0, &view), SFUMATO_OK);
  const auto* first = static_cast<const double*>(view.data);
  std::vector<double> points(first, first + 2 * view.rows);
  for (double& coordinate : points) coordinate += 3;
  ASSERT_EQ(sfumato_set_curve_points(c, document.get(), 0, 0, points.data(), view.rows), SFUMATO_OK)
      << sfumato_error_text(c);
  EXPECT_TRUE(exact() == before);
  ASSERT_EQ(sfumato_solve_again(c, document.get(), 1, picture.get()), SFUMATO_OK);
  EXPECT_FALSE(exact() == before);
}

TEST(CPixels, encoded_are_the_file_that_is_exported) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const PictureHandle picture = solve(c, document.get());
  double box[4];
  ASSERT_EQ(sfumato_picture_viewport(picture.get(), box), SFUMATO_OK);
  const auto width = static_cast<std::int32_t>(box[2]), height = static_cast<std::int32_t>(box[3]);
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(width) + 5;
  std::vector<std::uint8_t> pixels(row_bytes * static_cast<std::size_t>(height), 0xa5);
  const sfumato_image image{pixels.data(), row_bytes, width, height, SFUMATO_RGB8};
  ASSERT_EQ(sfumato_raster(c, picture.get(), &image, "dither background=white"), SFUMATO_OK);
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < 5; ++i) {
      const std::size_t between = static_cast<std::size_t>(y + 1) * row_bytes - 5;
      ASSERT_EQ(pixels[between + static_cast<std::size_t>(i)], 0xa5) << y;
    }
  }
  sfumato_bytes *encoded = nullptr, *exported = nullptr;
  ASSERT_EQ(sfumato_encode(c, &image, "png", nullptr, &encoded), SFUMATO_OK);
  const BytesHandle a(encoded);
  ASSERT_EQ(sfumato_export(c, picture.get(), "png", "background=white", &exported), SFUMATO_OK);
  const BytesHandle b(exported);
  EXPECT_TRUE(text_of(a.get()) == text_of(b.get()));
}

TEST(CPixels, of_a_window_are_those_of_the_whole_image) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const PictureHandle picture = solve(c, document.get());
  double box[4];
  ASSERT_EQ(sfumato_picture_viewport(picture.get(), box), SFUMATO_OK);
  const auto width = static_cast<std::int32_t>(box[2]), height = static_cast<std::int32_t>(box[3]);
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(width);
  std::vector<std::uint8_t> whole(row_bytes * static_cast<std::size_t>(height));
  std::vector<std::uint8_t> part(std::size_t{3} * 50 * 40);
  const sfumato_image image{whole.data(), row_bytes, width, height, SFUMATO_RGB8};
  const sfumato_image window{part.data(), 150, 50, 40, SFUMATO_RGB8};
  ASSERT_EQ(sfumato_raster(c, picture.get(), &image, "background=white dither"), SFUMATO_OK);
  ASSERT_EQ(sfumato_raster(c, picture.get(), &window, "background=white dither window=33,21,50,40"),
            SFUMATO_OK)
      << sfumato_error_text(c);
  for (std::size_t y = 0; y < 40; ++y) {
    const std::uint8_t* expected = whole.data() + row_bytes * (y + 21) + std::size_t{3} * 33;
    EXPECT_TRUE(std::equal(expected, expected + 150, part.data() + 150 * y)) << y;
  }
  sfumato_bytes *encoded = nullptr, *exported = nullptr;
  ASSERT_EQ(sfumato_encode(c, &window, "png", nullptr, &encoded), SFUMATO_OK);
  const BytesHandle a(encoded);
  ASSERT_EQ(
      sfumato_export(c, picture.get(), "png", "background=white window=33,21,50,40", &exported),
      SFUMATO_OK);
  const BytesHandle b(exported);
  EXPECT_TRUE(text_of(a.get()) == text_of(b.get()));
}

TEST(CPixels, of_windows_that_do_not_fit_are_refused) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("evening.xml"));
  const PictureHandle picture = solve(c, document.get());
  std::vector<std::uint8_t> pixels(std::size_t{3} * 50 * 40);
  const sfumato_image image{pixels.data(), 150, 50, 40, SFUMATO_RGB8};
  const auto code = [&](const char* options) {
    return sfumato_raster(c, picture.get(), &image, options);
  };
  EXPECT_EQ(code("window=0,0,50,41"), SFUMATO_BAD_USAGE) << "the image is of another size";
  EXPECT_EQ(code("window=0,0,50"), SFUMATO_BAD_USAGE);
  EXPECT_EQ(code("width=500"), SFUMATO_BAD_USAGE) << "without a window the image has the size";
  EXPECT_EQ(code("window=0,0,50,40 scale=2 width=500"), SFUMATO_BAD_USAGE);
  EXPECT_EQ(code("window=60,0,50,40 width=100"), SFUMATO_BAD_INPUT) << "beside the image";
  EXPECT_EQ(code("window=0,0,50,40 width=20000000"), SFUMATO_LIMIT);
  EXPECT_EQ(code("window=9000000,5000000,50,40 width=16000000"), SFUMATO_OK)
      << sfumato_error_text(c);
  sfumato_bytes* file = nullptr;
  EXPECT_EQ(sfumato_export(c, picture.get(), "pdf", "window=0,0,5,4", &file), SFUMATO_BAD_USAGE);
  EXPECT_EQ(file, nullptr);
}

TEST(CRead, gives_the_place_of_an_error) {
  const ContextHandle context = context_of();
  sfumato_document* document = nullptr;
  const std::string text = "<svg xmlns='http://www.w3.org/2000/svg'>\n  <path d='M0 0'";
  EXPECT_EQ(sfumato_read(context.get(), text.data(), text.size(), "x.svg", nullptr, &document),
            SFUMATO_BAD_INPUT);
  EXPECT_EQ(document, nullptr);
  std::int32_t line = 0, column = 0;
  sfumato_error_place(context.get(), &line, &column);
  EXPECT_EQ(line, 2);
  EXPECT_GT(column, 0);
  EXPECT_STREQ(sfumato_error_file(context.get()), "x.svg");
  EXPECT_STRNE(sfumato_error_text(context.get()), "");
}

TEST(CRead, takes_textures_from_the_loader_alone) {
  const ContextHandle context = context_of();
  const std::string text = example("textures.svg");
  sfumato_document* document = nullptr;
  EXPECT_EQ(sfumato_read(context.get(), text.data(), text.size(), "t", nullptr, &document),
            SFUMATO_BAD_INPUT);
  const auto load = [](void* user, const char* href, sfumato_deliver_fn deliver, void* sink) {
    ++*static_cast<int*>(user);
    const std::string bytes = example(href);
    deliver(sink, bytes.data(), bytes.size());
    return std::int32_t{0};
  };
  int count = 0;
  const sfumato_loader loader{load, &count};
  ASSERT_EQ(sfumato_read(context.get(), text.data(), text.size(), "t", &loader, &document),
            SFUMATO_OK)
      << sfumato_error_text(context.get());
  const DocumentHandle freed(document);
  EXPECT_GT(count, 0);
}

TEST(CRead, loaders_that_refuse_or_give_nothing_are_errors) {
  const ContextHandle context = context_of();
  const std::string text = example("textures.svg");
  sfumato_document* document = nullptr;
  const auto refuse = [](void*, const char*, sfumato_deliver_fn, void*) { return std::int32_t{1}; };
  const auto silent = [](void*, const char*, sfumato_deliver_fn, void*) { return std::int32_t{0}; };
  const auto null = [](void*, const char*, sfumato_deliver_fn deliver, void* sink) {
    deliver(sink, nullptr, 10);
    return std::int32_t{0};
  };
  const auto huge = [](void*, const char* href, sfumato_deliver_fn deliver, void* sink) {
    deliver(sink, href, SIZE_MAX);
    return std::int32_t{0};
  };
  const std::vector<sfumato_loader> loaders{
      {refuse, nullptr}, {silent, nullptr}, {null, nullptr}, {huge, nullptr}};
  for (const sfumato_loader& loader : loaders) {
    const std::int32_t code =
        sfumato_read(context.get(), text.data(), text.size(), "t", &loader, &document);
    EXPECT_TRUE(code == SFUMATO_BAD_INPUT || code == SFUMATO_LIMIT) << code;
    EXPECT_EQ(document, nullptr);
  }
}

TEST(CContext, cancelled_from_another_thread_ends_and_can_be_resumed) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(c, example("portrait.svg"));
  std::atomic<bool> begun = false;
  const auto note = [](void* user, const char*, double) {
    static_cast<std::atomic<bool>*>(user)->store(true);
  };
  sfumato_set_progress(c, note, &begun);
  std::thread other([&] {
    while (!begun) std::this_thread::yield();
    sfumato_cancel(c);
  });
  sfumato_picture* picture = nullptr;
  EXPECT_EQ(sfumato_solve(c, document.get(), "scale=8 max-error=0.05", &picture),
            SFUMATO_CANCELLED);
  EXPECT_EQ(picture, nullptr);
  other.join();
  EXPECT_EQ(sfumato_solve(c, document.get(), nullptr, &picture), SFUMATO_CANCELLED);
  sfumato_resume(c);
  sfumato_set_progress(c, nullptr, nullptr);
  EXPECT_TRUE(solve(c, document.get(), "max-error=off"));
}

TEST(CContext, bounds_memory_time_and_what_an_input_asks_for) {
  const std::string text = example("portrait.svg");
  sfumato_document* document = nullptr;
  sfumato_picture* picture = nullptr;
  const ContextHandle few = context_of("limit.curves=3");
  EXPECT_EQ(sfumato_read(few.get(), text.data(), text.size(), "in", nullptr, &document),
            SFUMATO_LIMIT);
  const ContextHandle rich = context_of(), poor = context_of("max-memory=2"),
                      late = context_of("max-time=1e-6");
  const DocumentHandle good = read_text(rich.get(), text);
  EXPECT_EQ(sfumato_solve(poor.get(), good.get(), nullptr, &picture), SFUMATO_LIMIT);
  EXPECT_EQ(sfumato_solve(late.get(), good.get(), nullptr, &picture), SFUMATO_LIMIT);
}

/// Freed handles release their memory; otherwise a small budget would be exhausted after some
/// rounds.
TEST(CContext, has_its_memory_again_when_handles_are_freed) {
  const ContextHandle context = context_of("max-memory=60 threads=1");
  const std::string text = example("evening.xml");
  for (int i = 0; i < 12; ++i) {
    const DocumentHandle document = read_text(context.get(), text);
    ASSERT_TRUE(solve(context.get(), document.get(), "max-error=off")) << i;
    sfumato_field* field = nullptr;
    ASSERT_EQ(sfumato_field_new(context.get(), document.get(), 0, nullptr, &field), SFUMATO_OK);
    sfumato_field_free(field);
  }
}

TEST(CDocument, has_the_stops_that_were_set) {
  const ContextHandle context = context_of();
  sfumato_document* made = nullptr;
  ASSERT_EQ(sfumato_document_new(context.get(), "artboard=0,0,10,10 interpolation=oklab", &made),
            SFUMATO_OK);
  const DocumentHandle document(made);
  const double line[] = {0, 5, 3, 5, 6, 5, 10, 5}, opacity[] = {0, 0.25, 1, 0.75};
  ASSERT_EQ(sfumato_insert_curve(context.get(), made, 0, UINT32_MAX, line, 4), SFUMATO_OK);
  ASSERT_EQ(sfumato_set_curve_stops(context.get(), made, 0, 0, SFUMATO_RIGHT, SFUMATO_OPACITY,
                                    SFUMATO_STOPS, SFUMATO_PARAMETER, opacity, 2),
            SFUMATO_OK);
  std::int32_t kind = 0, space = 0;
  double rows[4] = {9, 9, 9, 9};
  EXPECT_EQ(sfumato_curve_stops(made, 0, 0, SFUMATO_RIGHT, SFUMATO_OPACITY, &kind, &space, rows, 1),
            2u);
  EXPECT_EQ(rows[1], 0.25);
  EXPECT_EQ(rows[2], 9);
  EXPECT_EQ(kind, SFUMATO_STOPS);
  EXPECT_EQ(space, SFUMATO_PARAMETER);
  EXPECT_EQ(sfumato_curve_stops(made, 0, 0, SFUMATO_LEFT, SFUMATO_COLOR, &kind, &space, rows, 1),
            0u);
  EXPECT_EQ(kind, SFUMATO_OPEN);
  sfumato_document* copied = nullptr;
  ASSERT_EQ(sfumato_document_copy(context.get(), made, &copied), SFUMATO_OK);
  const DocumentHandle copy(copied);
  EXPECT_EQ(written(context.get(), copied), written(context.get(), made));
}

/// Sides with colours, gradients, a texture and an opacity given by a gradient, in OKLab.
constexpr const char* kPaints =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 64'"
    " sf:interpolation='oklab' sf:background='none'><defs>"
    "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='64'><stop stop-color='red'/>"
    "<stop offset='1' stop-color='#08f'/></linearGradient>"
    "<radialGradient id='r' gradientUnits='userSpaceOnUse' cx='32' cy='32' r='40'>"
    "<stop stop-color='#fff'/><stop offset='1' stop-color='#444'/></radialGradient>"
    "<pattern id='p' patternUnits='userSpaceOnUse' width='16' height='16'>"
    "<image href='t.png' width='16' height='16'/></pattern></defs>"
    "<g sf:diffuse='true'>"
    "<path d='M-8 12C20 4 40 24 72 10' sf:left='gold' sf:right='url(#g)'"
    " sf:left-opacity='1' sf:right-opacity='url(#r)'/>"
    "<path d='M-8 52C20 64 40 40 72 56' sf:left='url(#p)' sf:right='navy'"
    " sf:left-opacity='0.25' sf:right-opacity='0.75'/></g></svg>";

TEST(CField, mixes_paints_as_pictures_do) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const std::string picture_file = example("waves.png");
  const auto load = [](void* user, const char*, sfumato_deliver_fn deliver, void* sink) {
    const auto& file = *static_cast<const std::string*>(user);
    deliver(sink, file.data(), file.size());
    return std::int32_t{0};
  };
  const sfumato_loader loader{load, const_cast<std::string*>(&picture_file)};
  sfumato_document* read = nullptr;
  ASSERT_EQ(sfumato_read(c, kPaints, std::strlen(kPaints), "in", &loader, &read), SFUMATO_OK)
      << sfumato_error_text(c);
  const DocumentHandle document(read);
  constexpr std::uint32_t kSide = 64;
  const PictureHandle picture = solve(c, read, "max-error=0.25");
  std::vector<std::uint8_t> pixels(4 * kSide * kSide);
  const sfumato_image image{pixels.data(), 4 * kSide, kSide, kSide, SFUMATO_RGBA8};
  ASSERT_EQ(sfumato_raster(c, picture.get(), &image, nullptr), SFUMATO_OK);
  sfumato_field* made = nullptr;
  ASSERT_EQ(sfumato_field_new(c, read, 0, nullptr, &made), SFUMATO_OK) << sfumato_error_text(c);
  const FieldHandle field(made);
  std::vector<double> xy;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    xy.insert(xy.end(), {i % kSide + 0.5, i / kSide + 0.5});
  }
  std::vector<float> rgba(4 * kSide * kSide);
  ASSERT_EQ(sfumato_field_colors(c, made, xy.data(), kSide * kSide, rgba.data()), SFUMATO_OK)
      << sfumato_error_text(c);
  std::size_t far = 0;
  for (std::size_t i = 0; i < rgba.size(); ++i) far += std::abs(255 * rgba[i] - pixels[i]) > 2;
  EXPECT_LT(far, rgba.size() / 20);  // curves cut 160 of 4096 pixels
  const auto [least, most] = std::ranges::minmax(rgba);
  EXPECT_GE(least, 0);
  EXPECT_LE(most, 1);
}

TEST(CExactLayer, is_of_no_side_with_a_paint) {
  const ContextHandle context = context_of();
  sfumato_context* c = context.get();
  const DocumentHandle document = read_text(
      c,
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 64 64'><defs>"
      "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='9'><stop/></linearGradient></defs>"
      "<g sf:diffuse='true'><path d='M8 8h48' sf:left='gold' sf:right='url(#g)'/></g></svg>");
  const PictureHandle picture = solve(c, document.get());
  sfumato_bytes* bytes = nullptr;
  ASSERT_EQ(sfumato_exact_layer(c, picture.get(), 0, &bytes), SFUMATO_OK);
  EXPECT_EQ(text_of(BytesHandle(bytes).get()), std::string("\x01\0", 2));
}

}  // namespace
}  // namespace sfumato::test
