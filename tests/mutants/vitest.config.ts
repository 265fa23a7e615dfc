import { mergeConfig } from "vitest/config";
import base from "../../vitest.config";

/**
 * The checkout's Vitest configuration without the global setup, which builds the core: a copy uses the checkout's
 * modules. It stops at the first failed test.
 */
const { globalSetup: _, ...test } = base.test ?? {};

export default mergeConfig({ ...base, test }, { test: { bail: 1 } });
