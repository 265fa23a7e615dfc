import { mergeConfig } from "vitest/config";
import base from "../../vitest.config";

/**
 * The checkout's configuration of vitest without what runs before all tests, the build of the core: a copy has its modules from the
 * checkout. One test that fails is enough.
 */
const { globalSetup: _, ...test } = base.test ?? {};

export default mergeConfig({ ...base, test }, { test: { bail: 1 } });
