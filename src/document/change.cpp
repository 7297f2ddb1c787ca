#include "sfumato/document/change.hpp"

#include <string>
#include <utility>

#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "document/curve_change.hpp"

namespace sfumato {
namespace {

/// Makes changes without checking whether the document stays valid.
class Changer {
 public:
  explicit Changer(Document& document) : document_(document) {}

  Result<Change> operator()(ReplaceCurve& change) {
    SFUMATO_TRY(check(change.layer, change.curve, 0));
    std::swap(curves(change.layer)[change.curve], change.value);
    return Change(std::move(change));
  }

  Result<Change> operator()(InsertCurve& change) {
    SFUMATO_TRY(check(change.layer, change.curve, 1));
    std::vector<Curve>& list = curves(change.layer);
    list.insert(list.begin() + change.curve, std::move(change.value));
    return Change(RemoveCurve{change.layer, change.curve});
  }

  Result<Change> operator()(RemoveCurve& change) {
    SFUMATO_TRY(check(change.layer, change.curve, 0));
    std::vector<Curve>& list = curves(change.layer);
    const auto place = list.begin() + change.curve;
    InsertCurve inverse{change.layer, change.curve, std::move(*place)};
    list.erase(place);
    return Change(std::move(inverse));
  }

  Result<Change> operator()(ReplaceStack& change) {
    std::swap(document_.stack, change.value);
    return Change(std::move(change));
  }

  Result<Change> operator()(ReplaceDocument& change) {
    std::swap(document_, change.value);
    return Change(std::move(change));
  }

 private:
  std::vector<Curve>& curves(std::uint32_t layer) { return document_.layers[layer].curves; }

  /// Checks that the curve exists; `beyond` more than the last may be named.
  Status check(std::uint32_t layer, std::uint32_t curve, std::size_t beyond) const {
    if (layer >= document_.layers.size()) {
      return make_error(StatusCode::bad_input, "there is no layer " + std::to_string(layer));
    }
    if (curve < document_.layers[layer].curves.size() + beyond) return ok_status();
    return make_error(StatusCode::bad_input, "there is no curve " + std::to_string(curve) +
                                                 " in layer " + std::to_string(layer));
  }

  Document& document_;
};

/// Checks a document that was valid before a change with this inverse.
Status validate_change(const Context& context, const Document& document, const Change& inverse) {
  if (const auto* replaced = std::get_if<ReplaceCurve>(&inverse)) {
    const Curve& curve = document.layers[replaced->layer].curves[replaced->curve];
    Status status = validate_curve(context, document, replaced->layer, replaced->curve);
    const bool adds = status && adds_to_sums(replaced->value, curve);
    return adds ? validate_sums(context, document) : status;
  }
  if (const auto* inserted = std::get_if<RemoveCurve>(&inverse)) {
    Status status = validate_curve(context, document, inserted->layer, inserted->curve);
    return status ? validate_sums(context, document) : status;
  }
  if (std::holds_alternative<InsertCurve>(inverse)) return context.check();
  return validate(context, document);
}

/// Undoes the change on an error. That allocates nothing: the room of a removed curve still exists.
Result<Change> change_or_leave(const Context& context, Document& document, Change& change) {
  SFUMATO_TRY_ASSIGN(auto&& inverse, std::visit(Changer(document), change));
  Status valid = validate_change(context, document, inverse);
  if (valid) return std::move(inverse);
  const Result<Change> undone = std::visit(Changer(document), inverse);
  return undone ? valid : undone.status();
}

}  // namespace

Result<Change> apply_change(const Context& context, Document& document, Change change) {
  return public_verb(context, [&] { return change_or_leave(context, document, change); });
}

std::size_t bytes_of(const Change& change) {
  if (const auto* replace = std::get_if<ReplaceCurve>(&change)) return bytes_of(replace->value);
  if (const auto* insert = std::get_if<InsertCurve>(&change)) return bytes_of(insert->value);
  if (const auto* stack = std::get_if<ReplaceStack>(&change)) return bytes_of(stack->value);
  if (const auto* whole = std::get_if<ReplaceDocument>(&change)) return bytes_of(whole->value);
  return 0;
}

}  // namespace sfumato
