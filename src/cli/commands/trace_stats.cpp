#include "cli/commands/trace_stats.hpp"

#include <cmath>
#include <cstdio>

#include "base/text/json.hpp"
#include "cli/commands/stats.hpp"

namespace sfumato::cli {
namespace {

/// "1,998".
std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::string counted(std::size_t count, const char* what) {
  return grouped(count) + ' ' + what + (count == 1 ? "" : "s");
}

void write_members(const TraceState& state, JsonWriter& json) {
  json.member("curves", state.curves)
      .member("control_points", state.control_points)
      .member("stops", state.stops)
      .member("psnr_db", state.psnr_db);
}

TraceState last_of(const TraceStats& stats) {
  return stats.rounds.empty() ? TraceState() : stats.rounds.back();
}

}  // namespace

std::string to_json(const TraceFacts& facts, std::string_view input) {
  JsonWriter json;
  json.begin_object();
  if (!input.empty()) json.member("input", input);
  write_members(last_of(facts.trace), json);
  json.member("scale", facts.trace.scale)
      .member("noise", facts.trace.noise)
      .member("median_length_px", facts.trace.median_length_px)
      .member("curves_of_nine_tenths", facts.trace.curves_of_nine_tenths)
      .member("threads", facts.threads);
  if (facts.trace.textured_psnr_db) json.member("textured_psnr_db", *facts.trace.textured_psnr_db);
  if (facts.trace.points_needed > 0) json.member("points_needed", facts.trace.points_needed);
  json.key("rounds").begin_array();
  for (const TraceState& state : facts.trace.rounds) {
    json.begin_object().member("round", state.round);
    write_members(state, json);
    json.member("seconds", to_nanosecond(state.seconds)).end_object();
  }
  json.end_array();
  json.key("seconds")
      .begin_object()
      .member("read", to_nanosecond(facts.read_seconds))
      .member("trace", to_nanosecond(facts.trace_seconds))
      .member("write", to_nanosecond(facts.write_seconds))
      .member("total", to_nanosecond(facts.total_seconds))
      .end_object()
      .end_object();
  return json.text() + '\n';
}

std::string psnr_text(double psnr_db) {
  if (!std::isfinite(psnr_db)) return "no difference";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f dB", psnr_db);
  return text;
}

std::string summary(const TraceFacts& facts, std::string_view output) {
  const TraceState last = last_of(facts.trace);
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f s", facts.total_seconds);
  std::string nearness = psnr_text(last.psnr_db);
  if (const auto& textured = facts.trace.textured_psnr_db) {
    nearness += " (with its texture " + psnr_text(*textured) + ')';
  }
  return std::string(output) + ": " + counted(last.curves, "curve") + ", " +
         counted(last.control_points, "point") + ", " + nearness + " in " + seconds;
}

}  // namespace sfumato::cli
