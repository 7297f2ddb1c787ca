// The picture of a drawing that this browser stores.
import { useEffect, useState } from "preact/hooks";
import { Icon } from "../../icons.js";

/** @param picture null: a neutral sign stands in its place */
export function StoredPicture({ picture }: { readonly picture: Blob | null }) {
  const [url, setUrl] = useState<string | null>(null);
  useEffect(() => {
    if (!picture) return setUrl(null);
    const made = URL.createObjectURL(picture);
    setUrl(made);
    return () => URL.revokeObjectURL(made);
  }, [picture]);
  return (
    <span class="stored-picture">
      {url ? <img src={url} alt="" onError={() => setUrl(null)} /> : <Icon name="image" />}
    </span>
  );
}
