import "sfumato/element";

// What a test asks for later.
window.failures = [];
document.addEventListener("error", ({ target, message }) => window.failures.push([target.id, message]), true);
