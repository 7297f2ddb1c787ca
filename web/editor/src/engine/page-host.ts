// The workers and the module of this page, for all that starts workers.
import { createWorker, getModule } from "./host.js";
import type { Host } from "./seat.js";

export const pageHost: Host = { module: getModule, worker: createWorker };
