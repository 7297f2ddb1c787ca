#pragma once

// Not Sfumato's: a header that an embedder may have under this name.
enum class Status { fine, lost };
