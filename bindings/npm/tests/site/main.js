import "sfumato/element";

// Read by a test later.
window.failures = [];
document.addEventListener("error", ({ target, message }) => window.failures.push([target.id, message]), true);
