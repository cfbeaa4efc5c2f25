// Texts for people stand in the page's data, in its language (core/presentation/handout/script_texts.cpp): none stands in a script.

const say = (name, ...places) => data.texts[name].replace(/%([1-9])/g, (_, place) => places[place - 1]);
// A decimal with the page's decimal sign.
const spoken = number => number.replace('.', data.decimal);
// "8, 9 and 12"
const listed = names => (names.length < 2 ? names.join() : `${names.slice(0, -1).join(', ')} ${say('and')} ${names.at(-1)}`);
