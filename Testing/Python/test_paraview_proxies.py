# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the ParaView plugin says of the classes, against the classes themselves."""

import json
import re
import unittest
from pathlib import Path
from xml.etree import ElementTree

import vtkridges
from vtkmodules.vtkCommonDataModel import vtkDataObject

FOLDER = Path(__file__).resolve().parents[2] / "Wrapping" / "ParaView"

# Of the stages of vtkRidgesAndUmbilics: what it fixes, what its selection of types stands for, what
# is for comparison only, and what is about an output that it does not have.
NOT_FORWARDED = {
    "SetMongeOrder",
    "SetExtractMaximum",
    "SetExtractMinimum",
    "SetExtremalityRule",
    "SetFindPurplePoints",
}

# Those that run on all ranks of a server; with one rank they are the classes.
OF_RANKS = {
    "vtkPJetFitting": "vtkJetFitting",
    "vtkPRidgesAndUmbilics": "vtkRidgesAndUmbilics",
}

# Properties that only those have.
ONLY_ON_RANKS = {"SetDistributeLines", "SetNumberOfPieces"}


def elements():
    """The proxies of all files."""
    for path in sorted(FOLDER.glob("*.xml")):
        yield from ElementTree.parse(path).iter("SourceProxy")


def proxies():
    """Name of the class -> its element; without what proxies have in common, which has no class."""
    names = ((proxy.get("class"), proxy) for proxy in elements())
    return {OF_RANKS.get(name, name): proxy for name, proxy in names if name}


def array_choices():
    """The elements by which the arrays of vtkJetFitting are chosen."""
    (base,) = (proxy for proxy in elements() if proxy.get("name") == "MongeArrays")
    return properties(base)


def properties(proxy):
    return [
        element
        for element in proxy
        if element.tag.endswith("VectorProperty") and element.get("command") not in ONLY_ON_RANKS
    ]


def values(element):
    if element.tag == "StringVectorProperty":
        return [element.get("default_values")]
    number = int if element.tag.startswith("Int") else float
    return [number(text) for text in element.get("default_values").split()]


def is_abstract(cls):
    try:
        cls()
    except TypeError:
        return True
    return False


def setters(cls):
    """The methods Set... of a class that no class of VTK has, one per property: SetSurfaceToBlend is SetSurface."""
    vtk_class = next(base for base in cls.__mro__ if base.__module__ != cls.__module__)

    def is_own(name):
        choice = re.fullmatch(r"(Set\w+)To[A-Z]\w*", name)
        return not (choice and hasattr(cls, choice[1])) and not hasattr(vtk_class, name)

    return {name for name in dir(cls) if name.startswith("Set") and is_own(name)}


class Setting:
    """A property of an object, by the name of its setter, always as a list of numbers."""

    def __init__(self, element, instance):
        self._set = getattr(instance, element.get("command"))
        self._get = getattr(instance, "G" + element.get("command")[1:])

    def set(self, numbers):
        self._set(*numbers)

    def get(self):
        value = self._get()
        return list(value) if isinstance(value, tuple) else [value]


class TestParaViewProxies(unittest.TestCase):
    def for_each_property(self, check):
        """Calls check with each element and a new object; how often that was."""
        calls = 0
        for name, proxy in proxies().items():
            for element in properties(proxy):
                with self.subTest(f"{name}: {element.get('name')}"):
                    check(element, getattr(vtkridges, name)())
                    calls += 1
        return calls

    def test_every_class_has_a_proxy(self):
        classes = {name for name in vtkridges.__all__ if name.startswith("vtk")}
        classes -= {name for name in classes if is_abstract(getattr(vtkridges, name))}
        self.assertEqual(set(proxies()), classes)

    def test_every_setter_has_a_property_and_the_other_way_round(self):
        for name, proxy in proxies().items():
            with self.subTest(name):
                commands = [element.get("command") for element in properties(proxy)]
                self.assertEqual(len(commands), len(set(commands)))
                self.assertEqual(set(commands), setters(getattr(vtkridges, name)))

    def test_defaults_and_types(self):
        def check(element, instance):
            default = Setting(element, instance).get()
            self.assertEqual(values(element), default)
            self.assertEqual(len(default), int(element.get("number_of_elements")))
            kinds = {"DoubleVectorProperty": float, "StringVectorProperty": str}
            kind = kinds.get(element.tag, int)  # bool is an int
            self.assertIsInstance(default[0], kind)
            self.assertEqual(
                isinstance(default[0], bool), element.find("BooleanDomain") is not None
            )

        self.assertGreater(self.for_each_property(check), 40)

    def test_arrays_can_be_chosen_where_the_class_allows_it(self):
        name_of = vtkDataObject.FIELD_NAME()
        for name, proxy in proxies().items():
            instance = getattr(vtkridges, name)()
            chosen = instance.GetInputArrayInformation(0).Get(name_of)
            with self.subTest(name):
                self.assertEqual(proxy.get("base_proxyname") == "MongeArrays", chosen is not None)
            if chosen is None:
                continue
            for element in array_choices():
                with self.subTest(f"{name}: {element.get('name')}"):
                    index, *place, default = element.get("default_values").split(";")
                    self.assertEqual(place, ["0", "0", str(vtkDataObject.POINT)])
                    information = instance.GetInputArrayInformation(int(index))
                    self.assertEqual(default, information.Get(name_of))
                    self.assertEqual(element.get("name"), default + "Array")
                    self.assertEqual(element.find("ArrayListDomain").get("none_string"), default)
                    self.assertGreater(len(element.find("Documentation").text.strip()), 10)

    def test_ranges_are_those_of_the_class(self):
        checked = []

        def check(element, instance):
            domain = element.find("IntRangeDomain")
            domain = element.find("DoubleRangeDomain") if domain is None else domain
            setting = Setting(element, instance)
            # Radius and SemiAxes take any number, and say what is wrong as they are used.
            if domain is None or element.get("name") in ("Radius", "SemiAxes"):
                return
            checked.append(element)
            number = type(setting.get()[0])
            least = number(domain.get("min"))
            setting.set([least - 1])
            self.assertEqual(setting.get(), [least])
            if domain.get("max"):
                greatest = number(domain.get("max"))
                setting.set([greatest + 1])
                self.assertEqual(setting.get(), [greatest])
            else:
                setting.set([10**9])
                self.assertEqual(setting.get(), [10**9])

        self.for_each_property(check)
        self.assertGreater(len(checked), 10)

    def test_entries_are_those_of_the_class(self):
        checked = []

        def check(element, instance):
            entries = element.findall("EnumerationDomain/Entry")
            if not entries:
                return
            checked.append(element)
            setting = Setting(element, instance)
            self.assertEqual([int(e.get("value")) for e in entries], list(range(len(entries))))
            setting.set([len(entries)])  # clamped to the last
            self.assertEqual(setting.get(), [len(entries) - 1])
            for entry in entries:
                text = entry.get("text").replace(" ", "")
                getattr(instance, f"{element.get('command')}To{text}")()
                self.assertEqual(setting.get(), [int(entry.get("value"))])

        self.for_each_property(check)
        self.assertGreater(len(checked), 5)

    def test_everything_is_documented(self):
        for name, proxy in proxies().items():
            with self.subTest(name):
                documentation = proxy.find("Documentation")
                self.assertTrue(documentation.get("short_help"))
                self.assertTrue(documentation.get("long_help"))
                self.assertTrue(documentation.text.strip())

        def check(element, _):
            self.assertGreater(len(element.find("Documentation").text.strip()), 10)

        self.for_each_property(check)

    def test_labels_give_python_the_names_of_the_classes(self):
        for name, proxy in proxies().items():
            self.assertEqual("vtk" + proxy.get("label").replace(" ", ""), name)
            self.assertEqual("vtk" + proxy.get("name"), name)

    def test_all_are_in_the_menu_with_named_ports(self):
        for name, proxy in proxies().items():
            with self.subTest(name):
                menu = proxy.find("Hints/ShowInMenu")
                self.assertEqual(menu.get("category"), "Ridges")
                ports = proxy.findall("OutputPort")
                instance = getattr(vtkridges, name)()
                self.assertEqual(len(ports), instance.GetNumberOfOutputPorts())
                self.assertEqual([int(p.get("index")) for p in ports], list(range(len(ports))))
                self.assertEqual(
                    len(proxy.findall("InputProperty")), instance.GetNumberOfInputPorts()
                )

    def test_groups_and_decorators_name_properties_that_are_there(self):
        for name, proxy in proxies().items():
            names = {element.get("name") for element in properties(proxy)}
            with self.subTest(name):
                grouped = [p.get("name") for p in proxy.findall("PropertyGroup/Property")]
                self.assertEqual(len(grouped), len(set(grouped)))
                self.assertLessEqual(set(grouped), names)
                for decorator in proxy.iter("PropertyWidgetDecorator"):
                    self.assertIn(decorator.get("property"), names)

    def test_one_filter_forwards_the_properties_of_its_stages(self):
        whole = setters(vtkridges.vtkRidgesAndUmbilics)
        stages = set()
        for stage in ("JetFitting", "UmbilicDetection", "RidgeExtraction", "RidgeSharpnessFilter"):
            stages |= setters(getattr(vtkridges, "vtk" + stage))
        self.assertEqual(stages - whole, NOT_FORWARDED)
        self.assertEqual(whole - stages, set())

    def test_presets_are_the_default_colors(self):
        presets = {p["Name"]: p for p in json.loads((FOLDER / "RidgesPresets.json").read_text())}
        tables = json.loads((FOLDER / "RidgesSettings.json").read_text())["array_lookup_tables"]
        for preset, array in (
            ("Ridge types", "RidgeType"),
            ("Umbilic index", "Index"),
            ("Curvature lines", "PrincipalDirection"),
        ):
            for key in ("Annotations", "IndexedColors"):
                self.assertEqual(presets[preset][key], tables[array]["PVLookupTable"][key])
        annotations = presets["Ridge types"]["Annotations"]
        extraction = vtkridges.vtkRidgeExtraction
        for value, text in zip(annotations[::2], annotations[1::2]):
            constant = getattr(extraction, text.upper().replace(" ", "_"))
            self.assertEqual(int(value), constant)


if __name__ == "__main__":
    unittest.main()
