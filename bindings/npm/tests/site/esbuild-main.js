import { SfumatoPicture } from "sfumato/element";

SfumatoPicture.workerUrl = "worker.js"; // as an <a href> would have it
