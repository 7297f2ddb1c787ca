// Orzan's XML: the result is a valid document or an error with a reason, and memory is given back.
#include "fuzz.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/orzan/orzan.hpp"

using namespace sfumato;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  {
    const Result<ReadDocument> read = read_orzan(context, fuzz::as_text({data, size}), "fuzz.xml");
    if (read) {
      fuzz::require_ok(validate(context, read->document), "a document that is not valid");
    } else {
      fuzz::require_honest(read.status());
    }
  }
  fuzz::require(context.budget.used() == 0, "a reader keeps what it charged");
  return 0;
}
