#pragma once

// Not Sfumato's: what an embedder may have under this name.
struct Mesh {
  int vertex_count = 0;
};
