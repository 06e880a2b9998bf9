-- La balle qui rebondit.
-- Longueurs en m, temps en s, vitesses en m/s, accélérations
-- en m/s².

-- Exécutée une fois, quand la scène est en place.
function on_load()
  -- Donnez ici sa valeur à gravity.
end

-- Exécutée à chaque pas ; timestep est la durée du pas.
function on_update(timestep)
  -- D'abord gravity change la vitesse de circle1, puis cette
  -- vitesse le déplace.
end
