/** Addresses of scripts where a page demands Trusted Types: they go through the policy `hexlens`. */
interface Policy {
  createScriptURL(address: string): string
}

interface Policies {
  createPolicy(name: string, rules: Policy): Policy
}

const { trustedTypes } = globalThis as { readonly trustedTypes?: Policies }

let policy: Policy | undefined

/** Throws TypeError if the page does not allow the policy. */
export function scriptAddress(address: string | URL): string {
  policy ??= trustedTypes?.createPolicy('hexlens', { createScriptURL: own => own })
  return policy ? policy.createScriptURL(String(address)) : String(address)
}
