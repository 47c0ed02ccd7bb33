// SPDX-License-Identifier: GPL-3.0-or-later
// Show the map of what is chosen, at the values of the sliders; colours are white at zero where there are both signs.
const all = data.data[what.value]
let place = 0
sizes.forEach((size, k) => { place = place * size + (sliders[k] ? sliders[k].value : 0) })
const values = all.slice(place * n_cells, (place + 1) * n_cells)
let low = Infinity, high = -Infinity
for (const value of values) {
  if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value) }
}
if (low > high) { low = 0; high = 1 }
const both = low < 0 && high > 0
const strongest = Math.max(-low, high)
if (low === high) high = low + (Math.abs(low) || 1) * 1e-6
colours.setv({palette: both ? diverging : sequential, low: both ? -strongest : low, high: both ? strongest : high})
bar.title = about[what.value].label
if ('image' in source.data) {
  const image = source.data.image[0]
  image.set(values)
  source.change.emit()
} else {
  source.data = {...source.data, value: values}
}
