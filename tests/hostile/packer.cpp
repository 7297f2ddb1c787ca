#include "hostile/packer.hpp"

namespace sfumato::hostile {

Packer::Packer(Wrapper wrapper) {
  deflateInit2(&stream_, 9, Z_DEFLATED, static_cast<int>(wrapper), 9, Z_DEFAULT_STRATEGY);
}

void Packer::add(const std::string& bytes, bool last) {
  stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream_.avail_in = static_cast<uInt>(bytes.size());
  do {
    char room[65536];
    stream_.next_out = reinterpret_cast<Bytef*>(room);
    stream_.avail_out = sizeof(room);
    deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
    packed_.append(room, sizeof(room) - stream_.avail_out);
  } while (stream_.avail_out == 0);
}

std::string packed_run(Wrapper wrapper, char byte, std::size_t count) {
  const std::string block(std::size_t{1} << 20, byte);
  Packer packer(wrapper);
  for (; count > block.size(); count -= block.size()) packer.add(block, false);
  packer.add(block.substr(0, count), true);
  return packer.packed();
}

}  // namespace sfumato::hostile
