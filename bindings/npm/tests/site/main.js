import { SfumatoError, SfumatoPicture } from "sfumato/element";
import { SfumatoError as OfLibrary } from "sfumato";

// Read by a test later.
window.sfumato = { SfumatoError, SfumatoPicture, OfLibrary };
window.failures = [];
document.addEventListener("error", ({ target, message }) => window.failures.push([target.id, message]), true);
