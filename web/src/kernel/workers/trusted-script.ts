// Pages whose policy has `require-trusted-types-for 'script'` start workers only with addresses that a named
// policy has let through. Here it is called `girth`, and lets through what Girth starts itself.

interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): { createScriptURL(address: string): string };
}

const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };

/** Made for the first worker: a page that starts none need not allow it. */
let policy: ReturnType<TrustedTypes['createPolicy']> | undefined;

/** The address of a script of ours, trusted where the page lets us say so. */
export function trustedScript(address: string | URL): string | URL {
  try {
    policy ??= trustedTypes?.createPolicy('girth', { createScriptURL: (script) => script });
  } catch {
    // The page allows no policy of this name. Perhaps it needs none, or has a default one.
  }
  return policy?.createScriptURL(String(address)) ?? address;
}
