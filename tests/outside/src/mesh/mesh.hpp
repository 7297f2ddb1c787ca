#pragma once

// Not Sfumato's: a header that an embedder may have under this name.
struct Mesh {
  int vertex_count = 0;
};
