// Runs the tests of the installed npm package and prints TAP:
// node --expose-gc run.mjs TARBALL FOLDER
import { join } from "node:path";
import { testBuilds } from "./builds.mjs";
import { testNode } from "./node.mjs";
import { emptyProject, Tap } from "./tools.mjs";

const [tarball, folder] = process.argv.slice(2);
const tap = new Tap();
const project = join(folder, "project");
emptyProject(project, tarball);
await testNode(tap, project, tarball);
await testBuilds(tap, project, folder);
process.exitCode = tap.failures > 0 ? 1 : 0;
