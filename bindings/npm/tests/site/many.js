import "sfumato/element";

for (let i = 0; i < 40; ++i) {
  const picture = document.createElement("sfumato-picture");
  picture.src = i % 2 ? "halves.svg" : `halves.svg?${i}`; // half of them share one picture, the others have their own
  picture.alt = `Picture ${i}`;
  document.body.append(picture);
}
