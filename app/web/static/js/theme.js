// Before anything is painted: the colours that the reader chose, if any.
{
  const chosen = localStorage.getItem("theme");
  if (chosen) document.documentElement.dataset.theme = chosen;
}
