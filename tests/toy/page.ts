/** The application with an additional model, as pages with own models have it. */
import wasm from "../../build/core-test/toy.wasm?url";
import { addModel } from "../../web/src/models/index";

addModel("toy", async () => ({ ...(await import("./index")).model, wasm: new URL(wasm, document.baseURI).href }));
await import("../../web/src/app/main");
