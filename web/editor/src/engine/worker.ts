// The engine in a worker of its own.
import type { MessageEndpoint } from "./rpc.js";
import { serve } from "./serve.js";

serve(self as unknown as MessageEndpoint);
