// Before anything is painted: the colours that the reader chose, if any, and the requests that the view begins with,
// which are answered while its modules are loaded (api.js takes the answers).
{
  const chosen = localStorage.getItem("theme");
  if (chosen) document.documentElement.dataset.theme = chosen;

  const { root, ahead } = document.documentElement.dataset;
  const key = sessionStorage.getItem("key");
  const headers = key ? { Authorization: `Bearer ${key}` } : {};
  const ask = (path) => {
    const url = new URL(path.replace("{id}", location.pathname.split("/").pop()), new URL(root, location.href));
    return [url.href, fetch(url, { headers }).catch(() => null)]; // is asked again, which tells why
  };
  window.ahead = new Map(ahead.split(" ").filter(Boolean).map(ask));
}
