#include "capi/bytes.hpp"

const uint8_t* sfumato_bytes_data(const sfumato_bytes* bytes) {
  return bytes && !bytes->bytes.empty() ? bytes->bytes.data() : nullptr;
}

size_t sfumato_bytes_size(const sfumato_bytes* bytes) {
  return bytes ? bytes->bytes.size() : 0;
}

void sfumato_bytes_free(sfumato_bytes* bytes) {
  delete bytes;
}
