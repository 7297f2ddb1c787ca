#pragma once

// Not Sfumato's: what an embedder may have under this name.
enum class Status { fine, lost };
