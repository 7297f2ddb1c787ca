import "sfumato/element";

for (let i = 0; i < 40; ++i) {
  const picture = document.createElement("sfumato-picture");
  picture.src = i % 2 ? "halves.svg" : `halves.svg?${i}`; // a picture of their own, and one of all others
  picture.alt = `Picture ${i}`;
  document.body.append(picture);
}
